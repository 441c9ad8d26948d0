"""Read when each message of a bag came: ``.bag`` of ROS 1, ``.db3`` and ``.mcap`` of ROS 2.

A ``.db3`` is a database of SQLite, which Python reads; the other two need the package rosbags.
"""

from __future__ import annotations

import sqlite3
import tempfile
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

from .reading import BAGS, Entry, Log, NoLog, plain

__all__ = ["read_bag"]

_MOST = 500_000  # messages


def read_bag(data: bytes) -> Log:
    """Read a bag of which these are the bytes. Raises :class:`NoLog` if it cannot be read, or has no messages."""
    suffix = next(suffix for magic, suffix in BAGS.items() if data.startswith(magic))
    if suffix != ".db3" and not find_spec("rosbags"):
        raise NoLog(f"a {suffix} needs the package rosbags: pip install 'rosspin[bags]'")
    read = {".bag": _bag, ".db3": _db3, ".mcap": _mcap}[suffix]
    log = Log("bag", [], ros=1 if suffix == ".bag" else 2)
    with tempfile.TemporaryDirectory(prefix="rosspin-") as folder:
        path = Path(folder, f"log{suffix}")
        path.write_bytes(data)
        try:
            for found in read(path):
                log.entries.append(found)
                if len(log.entries) >= _MOST:
                    log.notes.append(f"Only the first {_MOST} messages were read.")
                    break
        except NoLog:
            raise
        except Exception as error:  # of what rosbags makes of broken bytes there is no end
            if not log.entries:
                raise NoLog(f"this {suffix} is broken, or not whole: {_reason(error, suffix)}") from error
            log.notes.append("The bag is broken further on: what stands before was read.")
    if not log.entries:
        raise NoLog("this bag has no messages")
    return log


def _reason(error: Exception, suffix: str) -> str:
    if suffix == ".bag":
        return "rosbag reindex may mend it"
    if suffix == ".mcap":
        return "mcap recover may mend it"
    return str(error)


def _message(time: int, topic: str, publisher: str = "") -> Entry:
    return Entry(time, plain(topic), plain(publisher), "", "", ())


def _bag(path: Path) -> Iterator[Entry]:
    from rosbags.rosbag1 import Reader

    with Reader(path) as bag:
        for connection, time, _ in bag.messages():
            yield _message(time, connection.topic, getattr(connection.ext, "callerid", None) or "")


def _db3(path: Path) -> Iterator[Entry]:
    database = sqlite3.connect(path)
    try:
        query = "SELECT timestamp, name FROM messages JOIN topics ON topics.id = topic_id ORDER BY timestamp"
        for time, topic in database.execute(query):
            if not (isinstance(time, int) and isinstance(topic, str)):  # a column of SQLite holds anything
                raise ValueError(f"a message on {topic!r} has the time {time!r}")
            yield _message(time, topic)
    finally:
        database.close()


def _mcap(path: Path) -> Iterator[Entry]:
    from rosbags.rosbag2.storage_mcap import McapReader

    reader = McapReader(path)
    reader.open()
    try:
        for connection, time, _ in reader.messages(list(reader.connections)):
            yield _message(time, connection.topic)
    finally:
        reader.close()
