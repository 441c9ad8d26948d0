"""Read when each message of a bag came: ``.bag`` of ROS 1, ``.db3`` and ``.mcap`` of ROS 2.

Bags come from anywhere, so they are read from the beginning to the end, in pieces, without what is in the messages;
nothing in them is run, and how much of them is read is bounded.
The formats: https://wiki.ros.org/Bags/Format/2.0, https://mcap.dev/spec, and rosbag2_storage_sqlite3's tables.
"""

from __future__ import annotations

import io
import re
import sqlite3
import sys
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from importlib import import_module
from pathlib import Path
from struct import unpack, unpack_from
from typing import Any, BinaryIO, NamedTuple

from .reading import BAGS, Entry, Log, NoLog, plain

__all__ = ["MOST_MESSAGES", "read_bag"]

# How much is read of a bag. Of a longer one, all that is said comes from this much.
MOST_MESSAGES = 500_000
_MOST_STEPS = 4_000_000  # records, and the fields in their headers
_MOST_BYTES = 10**9  # that are unpacked, or come through a pipe
_MOST_TOPICS = 10_000
_LARGEST = 10**6  # bytes that are needed in one piece, such as all that is said about a topic

# The classes that unpack a file in pieces.
_UNPACKERS = {
    "bz2": ("bz2", "BZ2File"),
    "lz4": ("lz4.frame", "LZ4FrameFile"),
    "zstd": ("compression.zstd" if sys.version_info >= (3, 14) else "backports.zstd", "ZstdFile"),
}


class _Full(Exception):
    """A bound has been reached; the message says which."""


class _Message(NamedTuple):
    time: int
    topic: str
    publisher: str = ""


def read_bag(magic: bytes, file: BinaryIO, progress: Callable[[float], None]) -> Log:
    """Read a bag of which ``magic`` has been read. Raises :class:`NoLog` if it cannot be read, or has no messages."""
    suffix = BAGS[magic]
    log = Log("bag", [], ros=1 if suffix == ".bag" else 2)
    if suffix == ".db3":
        messages = _db3(file, progress)
    else:
        messages = {".bag": _bag, ".mcap": _mcap}[suffix](_Stream(file, progress))
    try:
        for time, topic, publisher in messages:
            log.entries.append(Entry(time, topic, publisher, "", "", ()))
            if len(log.entries) >= MOST_MESSAGES:
                raise _Full(f"the first {MOST_MESSAGES:,} messages")
    except _Full as bound:
        if not log.entries:
            raise NoLog(f"this {suffix} was given up: {bound} had been read, and no message") from None
        log.notes.append(f"Only {bound} of the bag were read.")
    except NoLog:
        raise
    except Exception as error:  # broken bytes raise whatever reads them
        if not log.entries:
            raise NoLog(f"this {suffix} is broken, or not whole: {_reason(error, suffix)}") from error
        log.notes.append("The bag is broken further on, or not whole: what comes before was read.")
    finally:
        progress(1.0)
    if not log.entries:
        raise NoLog("this bag has no messages")
    log.entries.sort(key=lambda entry: entry.time)
    return log


def _reason(error: Exception, suffix: str) -> str:
    if suffix == ".bag":
        return "rosbag reindex may repair it"
    if suffix == ".mcap":
        return "mcap recover may repair it"
    return "it has too many tables" if str(error) == "interrupted" else str(error)


class _Topics(dict[int, tuple[str, str]]):
    """The topic and the publisher of each connection, by its number."""

    def add(self, number: int, topic: str, publisher: str = "") -> None:
        if len(self) >= _MOST_TOPICS:
            raise _Full(f"the first {_MOST_TOPICS:,} topics")
        self[number] = plain(topic)[:1000], plain(publisher)[:1000]


# --- files that are records, one after the other ----------------------------------------------------------------------


class _Stream:
    """Bytes that are read once, forwards; ``top`` is the file that they are unpacked from."""

    def __init__(self, file: BinaryIO, progress: Callable[[float], None], top: _Stream | None = None) -> None:
        self.file = file
        self._progress = progress
        self._top = top or self
        self._steps = self._read = 0
        self._size = 0  # of what can be passed over unread; unknown for a pipe
        if top is None and file.seekable():
            at = file.tell()
            self._size = file.seek(0, io.SEEK_END)
            file.seek(at)

    def begin(self, count: int) -> bytes:
        """Return the first bytes of the next record, or none at the end."""
        self.step()
        data = self.file.read(count)
        if data and len(data) < count:
            raise EOFError
        return data

    def take(self, count: int) -> bytes:
        if count > _LARGEST:
            raise ValueError(f"{count} bytes in one piece")
        data = self.file.read(count)
        if len(data) < count:
            raise EOFError
        self._count(count)
        return data

    def skip(self, count: int) -> None:
        if count < 0:
            raise ValueError("a record that is too short")
        if self._size:
            if self.file.tell() + count > self._size:
                raise EOFError
            self.file.seek(count, io.SEEK_CUR)
            return
        while count > 0:
            piece = len(self.file.read(min(count, 2**16)))
            if not piece:
                raise EOFError
            self._count(piece)
            count -= piece

    def step(self, count: int = 1) -> None:
        """Count what is read. Raises :class:`_Full` if that is enough."""
        top = self._top
        top._steps += count
        if top._steps > _MOST_STEPS:
            raise _Full(f"the first {_MOST_STEPS:,} records")
        if top._steps % 4096 < count and top._size:
            top._progress(top.file.tell() / top._size)

    def _count(self, count: int) -> None:
        self._top._read += count if not self._size else 0
        if self._top._read > _MOST_BYTES:
            raise _Full(f"the first {_MOST_BYTES / 1e9:g} GB")

    @contextmanager
    def unpacked(self, size: int, how: str) -> Iterator[_Stream]:
        """Give what the next bytes unpack to, and continue behind them."""
        module, name = _UNPACKERS[how]
        try:
            unpacker = getattr(import_module(module), name)
        except ImportError:
            raise NoLog(f"this bag is packed with {how}: pip install 'rosspin[bags]'") from None
        section = _Section(self, size)
        yield _Stream(unpacker(io.BufferedReader(section)), self._progress, self._top)
        self.skip(section.left)


class _Section(io.RawIOBase):
    """The next bytes of a stream, as a file."""

    def __init__(self, stream: _Stream, size: int) -> None:
        self._stream, self.left = stream, size

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: Any) -> int:
        data = self._stream.file.read(min(len(buffer), self.left))
        if not data and self.left:
            raise EOFError
        self.left -= len(data)
        buffer[: len(data)] = data
        return len(data)


def _mcap(stream: _Stream, topics: _Topics | None = None) -> Iterator[_Message]:
    """Read records, or with ``topics`` a chunk's."""
    inside, topics = topics is not None, _Topics() if topics is None else topics
    while head := stream.begin(9):
        kind, size = unpack("<BQ", head)
        if kind == 0x05:  # Message
            channel, _, time = unpack("<HIQ", stream.take(14))
            stream.skip(size - 14)
            yield _Message(time, *topics[channel])
        elif kind == 0x04:  # Channel
            data = stream.take(size)
            number, _, length = unpack_from("<HHI", data)
            topics.add(number, data[8 : 8 + length].decode())
        elif kind == 0x06 and not inside:  # Chunk
            *_, length = unpack("<QQQII", stream.take(32))
            how = stream.take(length).decode()
            (packed,) = unpack("<Q", stream.take(8))
            if how:
                with stream.unpacked(packed, how) as chunk:
                    yield from _mcap(chunk, topics)
            # Else its records follow, like the file's.
        elif kind in (0x02, 0x0F):  # Footer, Data End: what follows says it all again
            return
        elif kind in (0x00, 0x06):
            raise ValueError(f"a record of the kind {kind}")
        else:
            stream.skip(size)
    if not inside:
        raise EOFError


def _bag(stream: _Stream, topics: _Topics | None = None) -> Iterator[_Message]:
    """Read the first line and then the records, or with ``topics`` a chunk's."""
    inside, topics = topics is not None, _Topics() if topics is None else topics
    if not inside:
        version = stream.take(5)
        if version != b"V2.0\n":
            raise NoLog(f"this .bag is of version {version.decode(errors='replace').strip()}; rosspin reads V2.0")
    while length := stream.begin(4):
        fields = _fields(stream, *unpack("<I", length))
        (size,) = unpack("<I", stream.take(4))
        kind = fields["op"][0]
        if kind == 0x02:  # Message data
            seconds, nanoseconds = unpack("<II", fields["time"])
            stream.skip(size)
            yield _Message(seconds * 10**9 + nanoseconds, *topics[unpack("<I", fields["conn"])[0]])
        elif kind == 0x07:  # Connection
            publisher = _fields(stream, size).get("callerid", b"")
            topics.add(unpack("<I", fields["conn"])[0], fields["topic"].decode(), publisher.decode())
        elif kind == 0x05 and not inside:  # Chunk
            how = fields["compression"].decode()
            if how != "none":
                with stream.unpacked(size, how) as chunk:
                    yield from _bag(chunk, topics)
        else:
            stream.skip(size)


def _fields(stream: _Stream, length: int) -> dict[str, bytes]:
    data = stream.take(length)
    fields, at = {}, 0
    while at < length:
        stream.step()
        (size,) = unpack_from("<I", data, at)
        name, equals, value = data[at + 4 : at + 4 + size].partition(b"=")
        if not equals:
            raise ValueError("a field without a name")
        fields[name.decode()] = value
        at += 4 + size
    return fields


# --- databases --------------------------------------------------------------------------------------------------------


def _db3(file: BinaryIO, progress: Callable[[float], None]) -> Iterator[_Message]:
    with closing(_open_database(file)) as database:
        database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LARGEST)
        _check_tables(database)
        topics = _Topics()
        for count, (number, topic) in enumerate(database.execute("SELECT id, name FROM topics"), 1):
            if count > _MOST_TOPICS:
                raise _Full(f"the first {_MOST_TOPICS:,} topics")
            if not isinstance(topic, str):  # a column of SQLite holds anything
                raise ValueError(f"a topic has the name {topic!r:.60}")
            topics.add(number, topic)
        [[most]] = database.execute("SELECT max(rowid) FROM messages").fetchall()
        # Messages may be large. Of another kind of value only the name is read.
        database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, 2**31 - 1)
        columns = (f"CASE typeof({name}) WHEN 'integer' THEN {name} END" for name in ("timestamp", "topic_id"))
        query = f"SELECT typeof(timestamp), {', '.join(columns)} FROM messages"
        for count, (kind, time, number) in enumerate(database.execute(query), 1):
            if count > _MOST_STEPS:
                raise _Full(f"the first {_MOST_STEPS:,} rows")
            if number not in topics:
                continue
            if kind != "integer":
                raise ValueError(f"a message on {topics[number][0]!r} has a time of the type {kind}")
            if count % 4096 == 0:
                progress(count / max(count, min(most, MOST_MESSAGES)))
            yield _Message(time, *topics[number])


def _open_database(file: BinaryIO) -> sqlite3.Connection:
    """Open a file, or what is in memory, such that nothing is written: neither to it, nor next to it, nor elsewhere."""
    if isinstance(file, io.BytesIO):
        database = sqlite3.connect(":memory:")
        database.deserialize(file.getvalue())
        return database
    path = Path(file.name).absolute() if isinstance(file.name, str) else None  # else it is a number
    if path is None or not path.is_file():
        raise NoLog("a .db3 has to be a file that is named: it cannot be read from a pipe")
    return sqlite3.connect(f"{path.as_uri()}?mode=ro&immutable=1", uri=True)


def _check_tables(database: sqlite3.Connection) -> None:
    """Raise ValueError unless there are only tables of plain columns: a view, say, is a program, which may not end."""
    # Of more tables, SQLite would make much before the first is read.
    steps = iter(range(100))
    database.set_progress_handler(lambda: next(steps, None) is None, 1000)
    for kind, name, text in database.execute("SELECT type, name, sql FROM sqlite_master"):
        if text is not None and not re.match(r"CREATE (TABLE|(UNIQUE )?INDEX)\s", str(text), re.I):
            raise ValueError(f"{name!r:.60} is a {kind}, and bags have tables only")
    for table in ("topics", "messages"):
        columns = database.execute(f"PRAGMA table_xinfo({table})").fetchall()
        if not columns:
            raise ValueError(f"no such table: {table}")
        for _, column, *_, hidden in columns:
            if hidden:
                raise ValueError(f"the column {column!r:.60} of {table} is calculated")
    database.set_progress_handler(None, 0)
