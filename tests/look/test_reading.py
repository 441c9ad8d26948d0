"""What a log is read as, in all its forms; and that what is none ends in one clear line."""

from __future__ import annotations

from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from rosspin.look import NoLog, look
from rosspin.look.reading import Entry, read
from tests.helpers.known_logs import CASES, Case
from tests.helpers.known_logs_made import load

AT = 1_700_000_000_123_456_000


def only(text: str) -> Entry:
    (entry,) = read(text.encode()).entries
    return entry


@pytest.mark.parametrize(
    ("line", "node", "process"),
    [
        ("[INFO] [1700000000.123456]: speed 1.5", "", ""),
        ("[ INFO] [1700000000.123456000]: speed 1.5", "", ""),
        ("[INFO] [1800000000.5, 1700000000.123456]: speed 1.5", "", ""),  # the second one is ROS time
        ("\x1b[33m[WARN] [1700000000.123456]: speed 1.5\x1b[0m", "", ""),
        ("[INFO] [1700000000.123456000] [base]: speed 1.5", "base", ""),
        ("[base_node-2] [INFO] [1700000000.123456000] [mrp.base]: speed 1.5", "mrp.base", "base_node-2"),
        ("[rosout][INFO] 2023-11-14 22:13:20,123456: speed 1.5", "rosout", ""),
        ("2023-11-14T22:13:20.123456 speed 1.5", "", ""),
        ("1700000000.123456 speed 1.5", "", ""),
        ("Nov 14 robot ros[7]: [INFO] [1700000000.123456]: speed 1.5", "", ""),
    ],
)
def test_a_line_of_a_console(line: str, node: str, process: str) -> None:
    entry = only(line)
    assert (entry.time, entry.node, entry.process, entry.shape) == (AT, node, process, "speed #")
    assert entry.numbers == ("1.5",)


def test_the_tag_of_a_node_is_part_of_its_text() -> None:
    assert only("[INFO] [1.500000]: [SPINNER PY NODE] counter = 3").shape == "[SPINNER PY NODE] counter = #"


def test_numbers_in_words_are_names() -> None:
    assert only("[INFO] [1.5]: leg2 at -3.5e-2 of 0x7f, +4").shape == "leg2 at # of #, #"


@pytest.mark.parametrize("coding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "latin-1"])
def test_encodings(coding: str) -> None:
    lines = "".join(f"[INFO] [{n}.5]: Käse {n}\r\n" for n in range(8))
    log = read(lines.encode(coding))
    assert [entry.shape for entry in log.entries] == ["Käse #"] * 8


def test_what_stands_around_the_lines_is_set_aside() -> None:
    log = read(b"you@robot:~$ rosrun a b\n[INFO] [1.5]: one\nwithout a time\n^C\n")
    assert (len(log.entries), log.notes) == (1, ["3 lines without a time stamp: set aside."])


def test_a_table_of_rostopic() -> None:
    log = read(b"%time,field.header.seq,field.data\n1700000000123456000,7,0.5\n1700000000223456000,8,0.5\n")
    assert [entry.time for entry in log.entries] == [AT, AT + 100_000_000]
    assert log.entries[0].text == "header.seq=7 data=0.5"


def test_a_table_of_ros2_topic_echo() -> None:
    log = read(b"1700000000,123456000,map,0.5\n1700000000,223456000,map,0.7\n1700000000,323456000,map,0.1\n")
    assert [entry.time for entry in log.entries][:2] == [AT, AT + 100_000_000]
    assert log.ros == 2 and "stamps in the headers" in log.notes[0]


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "the file is empty"),
        (b" \n\n", "the file is empty"),
        (bytes(range(256)) * 40, "this is no text"),
        (b"counter = 1\ncounter = 2\n", "no line has a time stamp"),
        (b"[INFO] [base]: counter = 1\n", "RCUTILS_CONSOLE_OUTPUT_FORMAT"),
        (b"1,2\n3,4\n5,6\n", "this table has no times"),
        (b"%time,field.data\n", "has no rows"),
        (b"#ROSBAG V2.0\nhalf of it", "this .bag is broken, or not whole"),
        (b"SQLite format 3\0half of it", "this .db3 is broken, or not whole"),
        (b"\x89MCAP0\r\nhalf of it", "this .mcap is broken, or not whole"),
    ],
)
def test_what_is_no_log_says_so_in_a_line(data: bytes, says: str) -> None:
    with pytest.raises(NoLog) as caught:
        look(data)
    assert says in str(caught.value) and "\n" not in str(caught.value)


def test_a_file_that_is_too_long_is_read_in_part(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.look.LIMIT", 1000)
    monkeypatch.setattr("rosspin.look.reading.LIMIT", 1000)
    found = look(b"".join(b"[INFO] [%d.5]: counter = %d\n" % (n, n) for n in range(1000)))
    assert found.entries < 50 and found.notes[-1].startswith("Only the first")


@pytest.mark.parametrize(
    ("speed", "says"),
    [
        (1 / 3, "0.333 times the speed of the wall clock: 10 Hz here were 3.33 Hz there"),
        (1, "the speed of"),
    ],
)
def test_lines_with_two_stamps_say_how_fast_simulated_time_went(speed: float, says: str) -> None:
    lines = [f"[INFO] [{1.7e9 + n * 0.1 / speed:.6f}, {n * 0.1:.6f}]: tick {n}" for n in range(40)]
    found = look("\n".join(lines).encode())
    (note,) = found.notes
    assert says in note and found.series[0].period == pytest.approx(1e8)


@pytest.mark.parametrize(("wall", "kept"), [(40, "[INFO] [1700000000"), (10, "[INFO] [0")])
def test_of_stamps_of_two_clocks_one_is_looked_at(wall: int, kept: str) -> None:
    simulated = [f"[INFO] [{n * 0.1:.6f}] [b]: tick {n}" for n in range(20)]
    lines = [f"[INFO] [{1.7e9 + n * 0.3:.6f}] [a]: tock {n}" for n in range(wall)] + simulated
    found = look("\n".join(lines).encode())
    assert found.entries == max(wall, 20) and found.seconds < 20
    assert (
        f"{min(wall, 20)} lines with stamps of {'simulated time' if wall > 20 else 'the wall clock'} set aside"
        in found.notes[0]
    )


def test_of_very_many_lines_the_first_are_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.look.reading.MOST_LINES", 100)
    found = look(b"".join(b"[INFO] [%d.5]: counter = %d\n" % (n, n) for n in range(1000)))
    assert found.entries == 100 and found.notes == ("Only the first 100 lines were read.",)


@pytest.mark.parametrize("begin", [b"[INFO] [1.5]: a ", b"%time,field.data\n1500000000,"])
def test_of_a_very_long_line_the_beginning_is_read(begin: bytes) -> None:
    (entry,) = read(begin + b"7 " * 50_000).entries
    assert 1900 < len(entry.text) <= 2000 and len(entry.numbers) <= 1000


def test_of_very_many_different_lines_the_most_frequent_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.look.series.MOST", 3)
    words = ("a", "b", "a", "c", "a", "b", "d", "e", "c", "a")
    found = look(b"".join(b"[INFO] [%d.5]: %s\n" % (n, word.encode()) for n, word in enumerate(words * 10)))
    assert [series.name for series in found.series] == ["a", "b", "c"]
    assert found.notes == ("Of 5 different lines or topics, the 3 most frequent were looked at.",)


@settings(deadline=None)
@given(some.binary(max_size=300))
def test_whatever_it_is_there_is_no_trace(data: bytes) -> None:
    try:
        assert look(data).verdicts
    except NoLog as error:
        assert str(error)


MIXED = CASES[::12]
loaded = cache(load)


@settings(deadline=None)
@given(some.sampled_from(MIXED), some.lists(some.tuples(some.integers(0, 5999), some.binary(max_size=8)), max_size=12))
def test_nor_is_there_of_what_was_a_log(case: Case, changes: list[tuple[int, bytes]]) -> None:
    """Times that go backward, halves of lines, bytes of other files."""
    data = loaded(case)[:6000]
    for place, new in changes:
        data = data[:place] + new + data[place + len(new) // 2 :]
    test_whatever_it_is_there_is_no_trace.hypothesis.inner_test(data)  # type: ignore[attr-defined]
