"""Bags: what is read of them is what rosbags reads; and one that was made to do harm ends soon, in a clear line."""

from __future__ import annotations

import bz2
import io
import os
import sqlite3
import sys
import tracemalloc
from pathlib import Path
from struct import pack
from typing import Any

import pytest

from rosspin.__main__ import main
from rosspin.look import NoLog, bags, look
from tests.helpers.tree import TESTS

LOGS = TESTS / "look/recorded"
SPEED = [(1_700_000_000_000_000_000 + n * 50_000_000 + n % 5 * 100_000, n) for n in range(60)]


# --- whole ones -------------------------------------------------------------------------------------------------------


def written(folder: Path, plugin: str, packed: bool) -> Path:
    """Return a bag of ROS 2 that rosbags has written."""
    from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    types = get_typestore(Stores.ROS2_JAZZY)
    writer = Writer(folder / "bag", version=9, storage_plugin=StoragePlugin[plugin])
    if packed:
        writer.set_compression(CompressionMode.STORAGE, CompressionFormat.ZSTD)
    with writer as bag:
        connection = bag.add_connection("/speed", "std_msgs/msg/Int64", typestore=types)
        for time, number in SPEED:
            data = types.serialize_cdr(types.types["std_msgs/msg/Int64"](number), connection.msgtype)
            bag.write(connection, time, data)
    (file,) = (folder / "bag").glob(f"*.{'db3' if plugin == 'SQLITE3' else 'mcap'}")
    return file


@pytest.mark.parametrize(("plugin", "packed"), [("SQLITE3", False), ("MCAP", False), ("MCAP", True)])
def test_bags_of_ros_2(tmp_path: Path, plugin: str, packed: bool) -> None:
    file = written(tmp_path, plugin, packed)
    with open(file, "rb") as opened:
        found = look(opened, file.name)
    assert found.as_dict() == look(file.read_bytes(), file.name).as_dict()
    assert (found.kind, found.entries, found.series[0].name, found.notes) == ("bag", 60, "/speed", ())
    assert found.series[0].times == [time for time, _ in SPEED]
    assert found.verdicts[0].name == "healthy"


@pytest.mark.parametrize("compression", ["none", "bz2", "lz4"])
def test_bags_of_ros_1(tmp_path: Path, compression: str) -> None:
    from rosbags.rosbag1 import Writer
    from rosbags.typesys import Stores, get_typestore

    types, file = get_typestore(Stores.ROS1_NOETIC), tmp_path / "a.bag"
    writer = Writer(file)
    if compression != "none":
        writer.set_compression(Writer.CompressionFormat[compression.upper()])
    with writer as bag:
        connection = bag.add_connection("/speed", "std_msgs/msg/Int64", typestore=types, callerid="/motor")
        for time, number in SPEED:
            data = types.serialize_ros1(types.types["std_msgs/msg/Int64"](number), connection.msgtype)
            bag.write(connection, time, data)
    with open(file, "rb") as opened:
        (series,) = look(opened).series
    assert (series.name, series.publishers, series.times) == ("/speed", {"/motor"}, [time for time, _ in SPEED])


def test_a_recorded_bag_is_read_as_rosbags_reads_it() -> None:
    from rosbags.rosbag1 import Reader

    with Reader(LOGS / "r1_bag_20.bag") as reader:
        there = [(time, connection.topic) for connection, time, _ in reader.messages()]
    with open(LOGS / "r1_bag_20.bag", "rb") as file:
        found = look(file)
    assert sorted(there) == sorted((time, series.name) for series in found.series for time in series.times)


# --- made here, byte by byte ------------------------------------------------------------------------------------------

MCAP = b"\x89MCAP0\r\n"
BAG = b"#ROSBAG V2.0\n"


def record(kind: int, data: bytes) -> bytes:
    return pack("<BQ", kind, len(data)) + data


CHANNEL = record(4, pack("<HHI", 1, 1, 2) + b"/a" + bytes(8))
END = record(0x0F, bytes(4))


def message(n: int) -> bytes:
    return record(5, pack("<HIQQ", 1, n, n * 50_000_000, 0) + b"x")


def chunk(packed: bytes, how: bytes) -> bytes:
    return record(6, bytes(28) + pack("<I", len(how)) + how + pack("<Q", len(packed)) + packed)


def fields(**named: bytes) -> bytes:
    return b"".join(
        pack("<I", len(name) + 1 + len(value)) + name.encode() + b"=" + value for name, value in named.items()
    )


def record1(data: bytes, **header: bytes) -> bytes:
    head = fields(**header)
    return pack("<I", len(head)) + head + pack("<I", len(data)) + data


CONNECTION = record1(fields(callerid=b"/n"), op=b"\x07", conn=bytes(4), topic=b"/a")


def message1(n: int) -> bytes:
    return record1(b"x", op=b"\x02", conn=bytes(4), time=pack("<II", n // 20, n % 20 * 50_000_000))


def zstd(data: bytes) -> bytes:
    if sys.version_info >= (3, 14):
        from compression.zstd import compress
    else:
        from backports.zstd import compress
    return bytes(compress(data))


def lz4(data: bytes) -> bytes:
    from lz4.frame import compress

    return bytes(compress(data))


TWENTY = CHANNEL + b"".join(map(message, range(20)))
TWENTY1 = CONNECTION + b"".join(map(message1, range(20)))


@pytest.mark.parametrize(
    "data",
    [
        MCAP + TWENTY + END,
        MCAP + chunk(TWENTY, b"") + END,
        MCAP + chunk(zstd(TWENTY), b"zstd") + END,
        MCAP + CHANNEL + chunk(lz4(TWENTY), b"lz4") + END,
        BAG + TWENTY1,
        BAG + record1(TWENTY1, op=b"\x05", compression=b"none", size=pack("<I", len(TWENTY1))),
        BAG + record1(bz2.compress(TWENTY1), op=b"\x05", compression=b"bz2", size=pack("<I", len(TWENTY1))),
        BAG + record1(lz4(TWENTY1), op=b"\x05", compression=b"lz4", size=pack("<I", len(TWENTY1))),
    ],
)
def test_forms_of_bags(data: bytes) -> None:
    class Pipe(io.BytesIO):
        def seekable(self) -> bool:
            return False

    for file in (io.BytesIO(data), Pipe(data)):
        found = look(file)
        assert ([each.name for each in found.series], found.entries, found.notes) == (["/a"], 20, ())


@pytest.mark.parametrize("how", ["lz4", "zstd"])
def test_without_what_unpacks_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch, how: str) -> None:
    for module in ("lz4.frame", "backports.zstd", "compression.zstd"):
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(NoLog, match=rf"this bag is packed with {how}: pip install 'rosspin\[bags\]'"):
        look(MCAP + chunk(b"", how.encode()))


def test_in_a_page_it_says_where_bags_are_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rosspin.look.bags", None)
    with pytest.raises(NoLog, match="this is a bag, which is read on your computer only"):
        look((LOGS / "r1_bag_20.bag").read_bytes())


@pytest.mark.parametrize("data", [MCAP + TWENTY, BAG + TWENTY1])
@pytest.mark.parametrize("end", [b"\x05", bytes(1000), b"\xff" * 1000])
def test_what_comes_before_a_break_is_read(data: bytes, end: bytes) -> None:
    found = look(data + end)
    assert found.entries == 20
    assert found.notes == ("The bag is broken further on, or not whole: what comes before was read.",)


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (MCAP + END, "this bag has no messages"),
        (MCAP + message(1), "this .mcap is broken, or not whole: mcap recover may repair it"),
        (MCAP + chunk(lz4(chunk(b"", b"lz4")), b"lz4"), "this .mcap is broken"),
        (MCAP + CHANNEL + record(5, b""), "this .mcap is broken"),
        (MCAP + chunk(TWENTY, b"zip"), "this .mcap is broken"),
        (b"#ROSBAG V1.2\n", "this .bag is of version V1.2; rosspin reads V2.0"),
        (BAG + record1(b"", **{"op": b""}), "this .bag is broken, or not whole: rosbag reindex may repair it"),
        (BAG + pack("<I", 8) + bytes(8), "this .bag is broken"),
    ],
)
def test_what_is_no_bag(data: bytes, says: str) -> None:
    with pytest.raises(NoLog, match=says):
        look(data)


# --- bounds -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("bound", "most", "data", "says"),
    [
        ("MOST_MESSAGES", 12, MCAP + TWENTY, "Only the first 12 messages of the bag were read."),
        ("MOST_MESSAGES", 12, BAG + TWENTY1, "Only the first 12 messages of the bag were read."),
        ("_MOST_STEPS", 50, MCAP + TWENTY + record(0x80, b"") * 40, "Only the first 50 records of the bag were read."),
        ("_MOST_STEPS", 90, BAG + TWENTY1 + record1(b"", op=b"\x04") * 20, "Only the first 90 records of the bag"),
        (
            "_MOST_BYTES",
            10**6,
            MCAP + TWENTY + chunk(zstd(record(0x80, bytes(2_000_000))), b"zstd"),
            "Only the first 0.001 GB",
        ),
        (
            "_MOST_BYTES",
            10**6,
            MCAP + TWENTY + chunk(lz4(record(0x80, bytes(2_000_000))), b"lz4"),
            "Only the first 0.001 GB",
        ),
        (
            "_MOST_BYTES",
            10**6,
            BAG
            + TWENTY1
            + record1(bz2.compress(record1(bytes(2_000_000), op=b"\x04")), op=b"\x05", compression=b"bz2"),
            "Only the first 0.001 GB",
        ),
        (
            "_MOST_TOPICS",
            3,
            MCAP + TWENTY + b"".join(record(4, pack("<HHI", n, 1, 0)) for n in range(9)),
            "the first 3 topics",
        ),
    ],
)
def test_a_bound_is_named(monkeypatch: pytest.MonkeyPatch, bound: str, most: int, data: bytes, says: str) -> None:
    monkeypatch.setattr(bags, bound, most)
    (note,) = look(data).notes
    assert says in note


@pytest.mark.parametrize(
    "begin",
    [
        MCAP,
        MCAP + TWENTY,
        MCAP + pack("<BQ", 4, 10**9),
        MCAP + pack("<BQ", 0x80, 2**63),
        BAG,
        BAG + b"\xff\xff\xff\x3b",
    ],
)
def test_of_a_large_file_little_is_in_memory(tmp_path: Path, begin: bytes) -> None:
    path = tmp_path / "sparse"
    path.write_bytes(begin)
    os.truncate(path, 10**9)
    tracemalloc.start()
    try:
        with open(path, "rb") as file:
            look(file)
    except NoLog:
        pass
    finally:
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert peak < 10_000_000


def test_a_terminal_shows_how_far_it_is(tmp_path: Path) -> None:
    parts = list[float]()
    data = MCAP + CHANNEL + b"".join(map(message, range(20_000)))
    look(io.BytesIO(data), "", parts.append)
    assert parts == sorted(parts) and parts[-1] == 1 and 3 < len(parts) < 20 and all(0 < part <= 1 for part in parts)


# --- databases --------------------------------------------------------------------------------------------------------


def database(path: Path, *commands: str, values: tuple[Any, ...] = ()) -> Path:
    made: Any = sqlite3.connect(path)
    for command in commands:
        made.execute(command, values if "?" in command else ())
    made.commit()
    made.close()
    return path


TOPICS = ("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT)", "INSERT INTO topics VALUES (1, '/a')")
MESSAGES = "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, data BLOB)"

# Tables that share a page, made at once: one after another they take seconds.
MANY = """
    WITH RECURSIVE n(n) AS (VALUES (1) UNION ALL SELECT n + 1 FROM n LIMIT 12000)
    INSERT INTO sqlite_schema SELECT 'table', 't' || n, 't' || n, 2, 'CREATE TABLE t' || n || '(x)' FROM n
"""


@pytest.mark.parametrize(
    ("commands", "says"),
    [
        (["CREATE TABLE other (number)"], "no such table: topics"),
        (
            [
                *TOPICS,
                "CREATE VIEW messages AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) "
                "SELECT x AS timestamp, 1 AS topic_id FROM c",
            ],
            "'messages' is a view, and bags have tables only",
        ),
        (["CREATE VIEW topics AS SELECT 1 AS id, '/a' AS name", MESSAGES], "'topics' is a view, and bags"),
        ([*TOPICS, "CREATE VIRTUAL TABLE messages USING fts5(topic_id, timestamp)"], "'messages' is a table, and bags"),
        (
            [*TOPICS, MESSAGES, "CREATE TRIGGER t AFTER INSERT ON messages BEGIN DELETE FROM topics; END"],
            "'t' is a trigger, and bags have tables only",
        ),
        (
            [*TOPICS, "CREATE TABLE messages(topic_id, timestamp AS (length(hex(zeroblob(1000000000)))))"],
            "the column 'timestamp' of messages is calculated",
        ),
        (["CREATE TABLE topics(id, name AS ('/a'))", MESSAGES], "the column 'name' of topics is calculated"),
        ([*TOPICS, MESSAGES, "UPDATE topics SET name = hex(zeroblob(1000000))"], "string or blob too big"),
        ([*TOPICS, MESSAGES, "PRAGMA writable_schema = ON", MANY], "it has too many tables"),
    ],
)
def test_a_database_that_is_no_bag(tmp_path: Path, commands: list[str], says: str) -> None:
    path = database(tmp_path / "a.db3", "BEGIN", *commands)
    with open(path, "rb") as file, pytest.raises(NoLog, match=f"this .db3 is broken, or not whole: {says}"):
        look(file)


@pytest.mark.parametrize(
    ("time", "topic", "says"),
    [
        (None, "/speed", "a message on '/speed' has a time of the type null"),
        (1.5, "/speed", "a message on '/speed' has a time of the type real"),
        ("soon" * 100_000, "/speed", "a message on '/speed' has a time of the type text"),
        (17, b"/speed" * 1000, "a topic has the name b'/speed"),
    ],
)
def test_a_db3_whose_columns_hold_something_else(tmp_path: Path, time: object, topic: object, says: str) -> None:
    path = database(tmp_path / "a.db3", "CREATE TABLE topics (id, name)", "CREATE TABLE messages (topic_id, timestamp)")
    database(path, "INSERT INTO topics VALUES (1, ?)", values=(topic,))
    database(path, "INSERT INTO messages VALUES (1, ?)", values=(time,))
    with pytest.raises(NoLog, match=f"this .db3 is broken, or not whole: {says}") as raised:
        look(path.read_bytes())
    assert len(str(raised.value)) < 200


def test_topics_of_one_number_are_counted_each(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pages of a table that lead to each other say one without end."""
    monkeypatch.setattr(bags, "_MOST_TOPICS", 50)
    rows = ",".join("(1, '/a')" for _ in range(60))
    path = database(tmp_path / "a.db3", "CREATE TABLE topics (id, name)", f"INSERT INTO topics VALUES {rows}", MESSAGES)
    with pytest.raises(NoLog, match="the first 50 topics had been read, and no message"):
        look(path.read_bytes())


def test_large_messages_are_passed_over(tmp_path: Path) -> None:
    rows = "SELECT value, 1, value * 50000000, zeroblob(2000000) FROM json_each('[1,2,3,4,5,6,7,8]')"
    path = database(tmp_path / "a.db3", *TOPICS, MESSAGES, f"INSERT INTO messages {rows}")
    with open(path, "rb") as file:
        assert look(file).entries == 8


def test_a_broken_page_ends_in_a_line(tmp_path: Path) -> None:
    rows = "WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c WHERE x < 9999) SELECT x, 1, x, 'y' FROM c"
    path = database(tmp_path / "a.db3", *TOPICS, MESSAGES, f"INSERT INTO messages {rows}")
    data = bytearray(path.read_bytes())
    data[20 * 4096 : 21 * 4096] = b"\xff" * 4096
    found = look(bytes(data))
    assert 0 < found.entries < 9999 and "The bag is broken further on" in found.notes[0]


def test_nothing_is_written_beside_a_bag(tmp_path: Path) -> None:
    path = database(tmp_path / "a.db3", "PRAGMA journal_mode = WAL", *TOPICS, MESSAGES)
    database(path, "INSERT INTO messages VALUES (1, 1, 7, 'x')")
    before = path.read_bytes()
    path.chmod(0o400)
    with open(path, "rb") as file:
        assert look(file).entries == 1
    assert sorted(each.name for each in tmp_path.iterdir()) == ["a.db3"] and path.read_bytes() == before


# --- what is no file --------------------------------------------------------------------------------------------------


def says(capsys: pytest.CaptureFixture[str], path: Path | str) -> str:
    assert main(["look", str(path)]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    return err


def test_a_device_is_no_log(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert says(capsys, os.devnull) == f"rosspin: {os.devnull}: this is a device, and no log\n"
    (tmp_path / "link").symlink_to("/dev/zero")
    assert says(capsys, tmp_path / "link") == f"rosspin: {tmp_path}/link: this is a device, and no log\n"


def test_a_named_pipe_is_not_waited_for(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert says(capsys, tmp_path / "pipe") == f"rosspin: {tmp_path}/pipe: the file is empty\n"


def test_a_db3_cannot_come_through_a_pipe(tmp_path: Path) -> None:
    reader, writer = os.pipe()
    with open(reader, "rb") as file:
        os.write(writer, database(tmp_path / "a.db3", *TOPICS, MESSAGES).read_bytes()[:4096])
        os.close(writer)
        with pytest.raises(NoLog, match="a .db3 has to be a file that is named"):
            look(file)
