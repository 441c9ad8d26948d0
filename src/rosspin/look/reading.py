"""Read a stranger's log: what it says, when, and who said so.

A log is the console of ROS 1 or ROS 2, also with colours, under a launch, or pasted with what was around it; a table
of ``ros2 topic echo --csv`` or ``rostopic echo -p``; or a bag, which :mod:`.bags` reads.
"""

from __future__ import annotations

import codecs
import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import datetime

__all__ = ["LIMIT", "MOST_LINES", "Entry", "Log", "NoLog", "read"]

NS = 10**9

# Of a longer file only this much is read, in bytes: some 200,000 lines, which take some seconds.
LIMIT = 16_000_000

# Since when (ns) times are of the wall clock, and not of a simulated one, which begins near 0.
_EPOCH_BEGINS = 10**9 * NS

# Of a text, no more lines than these are looked at, and of a line no more characters.
MOST_LINES = 500_000
_WIDEST = 2_000

# The first bytes of a bag.
BAGS = {b"#ROSBAG ": ".bag", b"SQLite format 3\0": ".db3", b"\x89MCAP0\r\n": ".mcap"}


class NoLog(ValueError):
    """This is no log that can be looked at; the message says why, and what to do."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One line of a console, one row of a table or one message of a bag.

    ``time`` is in ns since the epoch, or since whatever its clock began with; ``node`` is the logger or the topic, and
    ``process`` what ``ros2 launch`` puts before a line, each empty if the log does not say. ``shape`` is the text with
    ``#`` for each number, and ``numbers`` are these.
    """

    time: int
    node: str
    process: str
    text: str
    shape: str
    numbers: tuple[str, ...]


@dataclass
class Log:
    """What was read: ``kind`` is console, table or bag, ``notes`` say in sentences what one should know of it."""

    kind: str
    entries: list[Entry]
    notes: list[str] = field(default_factory=list)
    said: list[str] = field(default_factory=list)  # by ROS itself, about the nodes
    ros: int = 0  # 1 or 2, if the kind of file says so


# Colours, titles of terminals, and what else a terminal obeys.
_ESCAPE = re.compile(
    r"\x1b(?:\[[0-9;?]*[ -/]*[@-~]|\][^\x07\x1b]*(?:\x07|\x1b\\)?|[@-Z\\-_])|[\x00-\x08\x0b-\x1f\x7f-\x9f]"
)

_SEVERITY = r"(?:DEBUG|INFO|WARN|WARNING|ERROR|FATAL)"
# Before the line there may be what a launch puts there, or what a terminal showed. On ROS time a second stamp follows,
# which is the one that the node's timers go by. In ROS 2 the name of the logger follows.
_LINE = re.compile(
    r"(?:^|.*?\s)?(?:\[(?P<process>[^][\s]+-\d+)\] )?\[ ?" + _SEVERITY + r" ?\] ?"
    r"\[(?P<wall>\d{1,12}\.\d+)(?:, ?(?P<ros>\d{1,12}\.\d+))?\](?: \[(?P<node>[^][]*)\])?:? ?(?P<text>.*)"
)
# rospy's files: [rosout][INFO] 2026-11-23 15:38:03,123: text
_FILE = re.compile(
    r"\[(?P<node>[\w./]+)\]\[" + _SEVERITY + r"\] (?P<day>\d{4}-\d\d-\d\d[ T][\d:]{8}[.,]\d+): (?P<text>.*)"
)
# Any other form: a number of seconds since 2001 or later, or a date with a fraction of a second.
_EPOCH = re.compile(r"(?<![\d.])(?P<wall>[1-9]\d{9}\.\d{1,9})(?!\d)")
_DATE = re.compile(r"(?P<day>\d{4}-\d\d-\d\d[ T]\d\d:\d\d:\d\d[.,]\d+)(?:Z|[+-]\d\d:?\d\d)?")
# On ROS time: what the wall clock said, and then what ROS time was.
_BOTH = re.compile(r"\[(\d{1,12}\.\d+), ?(\d{1,12}\.\d+)\]")
_UNTIMED = re.compile(r"\[ ?" + _SEVERITY + r" ?\]")

_NUMBER = re.compile(r"0x[0-9a-fA-F]+|(?<![A-Za-z_\d.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")

# What ROS says of two nodes of one name: rospy of the one that has to go, rcl of the second in one process.
_SAID = re.compile(r"new node registered with same name|Publisher already registered for")


def read(data: bytes) -> Log:
    """Read a text. Raises :class:`NoLog` if nothing can be made of it."""
    if not data.strip():
        raise NoLog("the file is empty")
    lines = _decode(data).splitlines()
    cut = len(lines) > MOST_LINES
    del lines[MOST_LINES:]
    try:
        table = _table(lines)
    except csv.Error:  # of what looked like one
        table = None
    log = table if table is not None else _console(lines)
    if len(data) >= LIMIT:
        log.notes.append(f"Only the first {LIMIT // 10**6} MB were read.")
    elif cut:
        log.notes.append(f"Only the first {MOST_LINES:,} lines were read.")
    return log


def _decode(data: bytes) -> str:
    for mark, coding in (
        (codecs.BOM_UTF8, "utf-8-sig"),
        (codecs.BOM_UTF16_LE, "utf-16"),
        (codecs.BOM_UTF16_BE, "utf-16"),
    ):
        if data.startswith(mark):
            return data.decode(coding, errors="replace")
    head = data[:4096]
    if head.count(0) > len(head) // 4 and b"\0[\0" in head + b"\0":  # PowerShell's, without its mark
        return data.decode("utf-16-be" if head[0] == 0 else "utf-16-le", errors="replace")
    odd = sum(byte < 9 or 13 < byte < 27 for byte in head)
    if odd > len(head) // 50:
        raise NoLog("this is no text: give it a console log, a table of rostopic or ros2 topic echo, or a bag")
    try:
        return data.decode()
    except UnicodeDecodeError:
        return data.decode("latin-1")  # in which every byte is a letter; what is cut off at the end of a file, too


def plain(text: str) -> str:
    """Remove the escape sequences that a terminal would obey."""
    return _ESCAPE.sub("", text)


def shape(text: str) -> tuple[str, tuple[str, ...]]:
    """Return the text with ``#`` for each number, and the numbers. Those in a word, as in leg2, are part of it."""
    return _NUMBER.sub("#", text), tuple(_NUMBER.findall(text))


def entry(time: int, node: str, process: str, text: str) -> Entry:
    """Make an entry of its text."""
    text = text[:_WIDEST]
    return Entry(time, node, process, text, *shape(text))


# --- consoles ---------------------------------------------------------------------------------------------------------


def _console(lines: Sequence[str]) -> Log:
    log = Log("console", [])
    untimed = other = 0
    pairs = list[tuple[int, int]]()  # what the wall clock and ROS time said in one line
    for raw in lines:
        line = plain(raw[:_WIDEST]).strip()
        if not line:
            continue
        if _SAID.search(line):
            log.said.append(line)
        if both := _BOTH.search(line):
            pairs.append((_ns(both[1]), _ns(both[2])))
        found = _entry(line)
        if found is not None:
            log.entries.append(found)
        elif _UNTIMED.search(line):
            untimed += 1
        else:
            other += 1
    if not log.entries:
        raise NoLog(_no_times(untimed))
    if untimed:
        log.notes.append(f"{_lines(untimed)} of a node without a time stamp: set aside.")
    if other:
        log.notes.append(f"{_lines(other)} without a time stamp: set aside.")
    _tell_clocks(log, pairs)
    return log


def _tell_clocks(log: Log, pairs: Sequence[tuple[int, int]]) -> None:
    """Say so if stamps are of simulated time, how fast that went, and set aside what has stamps of another clock."""
    simulated = [each for each in log.entries if each.time < _EPOCH_BEGINS]
    wall = [each for each in log.entries if each.time >= _EPOCH_BEGINS]
    if simulated and wall:
        fewer, more = sorted((simulated, wall), key=len)
        clock = "simulated time" if fewer is simulated else "the wall clock"
        log.notes.append(
            "Stamps of the wall clock and of simulated time are mixed in this log, and do not compare: "
            f"{_lines(len(fewer))} with stamps of {clock} set aside."
        )
        log.entries[:] = more
    (wall_first, first), (wall_last, last) = (pairs[0], pairs[-1]) if pairs else ((0, 0), (0, 0))
    if wall_last > wall_first and last > first:
        speed = (last - first) / (wall_last - wall_first)
        went = f"{speed:.3g} times the speed of the wall clock: 10 Hz here were {10 * speed:.3g} Hz there"
        if abs(speed - 1) < 0.02:
            went = "the speed of the wall clock"
        log.notes.append(f"The lines have stamps of the wall clock and of ROS time, which counts. It went at {went}.")


def _lines(count: int) -> str:
    return f"{count} line{'s' * (count != 1)}"


def _no_times(untimed: int) -> str:
    if untimed:
        return (
            "its log lines have no time stamps: the console's format was changed. In ROS 2, unset "
            "RCUTILS_CONSOLE_OUTPUT_FORMAT or put {time} into it; in ROS 1, ROSCONSOLE_FORMAT and ${time}"
        )
    return (
        "no line has a time stamp. Lines of print() have none: log with get_logger().info() or rospy.loginfo(), or "
        "use a tool that puts one before each line, as in: … | ts '%Y-%m-%d %H:%M:%.S'"
    )


def _entry(line: str) -> Entry | None:
    if match := _LINE.match(line):
        return entry(_ns(match["ros"] or match["wall"]), match["node"] or "", match["process"] or "", match["text"])
    if match := _FILE.search(line):
        time, text, node = _date(match["day"]), match["text"], match["node"]
    elif match := _EPOCH.search(line) or _DATE.search(line):
        time = _ns(match["wall"]) if "wall" in match.re.groupindex else _date(match["day"])
        text, node = (line[: match.start()] + line[match.end() :]).strip(), ""
    else:
        return None
    return None if time is None else entry(time, node, "", text)


def _ns(seconds: str) -> int:
    whole, _, part = seconds.partition(".")
    return int(whole) * NS + int(part[:9].ljust(9, "0"))


def _date(text: str) -> int | None:
    whole, _, part = text.replace(",", ".").partition(".")
    try:
        # As if it were UTC: what counts is the time from one line to the next.
        return int(datetime.fromisoformat(f"{whole}+00:00").timestamp()) * NS + int(part[:9].ljust(9, "0"))
    except ValueError:  # such as a 31st of February
        return None


# --- tables -----------------------------------------------------------------------------------------------------------


def _table(lines: Sequence[str]) -> Log | None:
    """Read ``rostopic echo -p``, whose first column is when a message came; or ``ros2 topic echo --csv``."""
    first = next((line for line in lines if line.strip()), "")
    if first.startswith("%time"):
        return _echo(lines)
    rows = [row for row in csv.reader(line for line in lines[:50] if line.strip())]
    if len(rows) < 2 or len({len(row) for row in rows[:-1]}) != 1 or "[" in first or not _is_csv(rows[:-1]):
        return None
    stamped = _stamp_columns(rows)
    if stamped is None:
        raise NoLog(
            "this table has no times: ros2 topic echo --csv writes only what is in a message, and this one has no "
            "header with a stamp. Record a bag instead: ros2 bag record TOPIC"
        )
    entries = [
        entry(int(row[stamped]) * NS + int(row[stamped + 1]), "", "", ",".join(row[:stamped] + row[stamped + 2 :]))
        for row in csv.reader(lines)
        if len(row) == len(rows[0]) and _is_whole(row[stamped]) and _is_whole(row[stamped + 1])
    ]
    note = "The times are the stamps in the headers: when it was measured, not when it came."
    return Log("table", entries, [note], ros=2)


def _is_whole(cell: str) -> bool:
    return cell.isdecimal() and len(cell) < 20


def _is_csv(rows: Sequence[Sequence[str]]) -> bool:
    cells = [cell for row in rows for cell in row]
    return sum(bool(_NUMBER.fullmatch(cell)) for cell in cells) > len(cells) // 3


def _stamp_columns(rows: Sequence[Sequence[str]]) -> int | None:
    """Find the column of the first ``builtin_interfaces/Time``: steady seconds, then nanoseconds below 1e9."""
    for column in range(len(rows[0]) - 1):
        pairs = [row[column : column + 2] for row in rows[:-1]]
        if not all(len(pair) == 2 and _is_whole(pair[0]) and _is_whole(pair[1]) for pair in pairs):
            continue
        seconds = [int(pair[0]) for pair in pairs]
        parts = [int(pair[1]) for pair in pairs]
        if max(parts) > 1_000_000 and max(parts) < NS and 0 <= max(seconds) - min(seconds) < 10_000 < max(seconds):
            return column
    return None


def _echo(lines: Sequence[str]) -> Log:
    names: list[str] = []
    log = Log("table", [], ros=1)
    for row in csv.reader(lines):
        if row and row[0] == "%time":
            names = row
        elif names and len(row) == len(names) and _is_whole(row[0]):
            text = " ".join(
                f"{name.removeprefix('field.')}={cell}" for name, cell in zip(names[1:], row[1:], strict=True)
            )
            log.entries.append(entry(int(row[0]), "", "", text))
    if not log.entries:
        raise NoLog("this table of rostopic has no rows")
    log.notes.append("The times are when rostopic received each message.")
    return log
