"""Run a scenario; what it gave, on whatever runtime, and how two such outcomes differ: status, text, times."""

from __future__ import annotations

import ast
import difflib
import re
from collections.abc import Iterator
from typing import NamedTuple

from .python_texts import of_any_python

__all__ = [
    "CTRL_C",
    "JITTER",
    "P",
    "TOLERANCE",
    "Outcome",
    "differences",
    "outcome",
]

P = 0.4  # the period in the scenarios, s
TOLERANCE = 0.3 * P
JITTER = 0.01  # what each block may take longer (s) and the scenario still count; a process later than that has stalled
CTRL_C = 3.6 * P


class Outcome(NamedTuple):
    """What a scenario gave: exit status, lines that must be the same, times by label; its end, and its longest stall.

    That (s) is how late a plain timer next to the node came at most, or the Ctrl-C; 0 if it all came in time.
    """

    status: int
    text: str
    marks: dict[str, list[list[float | None]]]
    end: float | None
    stalled: float


# A mark is written in one go; it may stand within a line that another thread writes in several, as a traceback's are.
_MARK = re.compile(r"@(\w+)((?: (?:None|-?\d+\.\d+))*)\n")


def outcome(console: str, status: int, end: float | None) -> Outcome:
    """Read a console."""
    marks: dict[str, list[list[float | None]]] = {}
    stalled = 0.0
    for label, words in _MARK.findall(console):
        times = [None if word == "None" else float(word) for word in words.split()]
        if label == "end":
            end = times[0]
        elif label == "stall":
            stalled = max(stalled, times[0] or 0.0)
        elif label != "zero":
            marks.setdefault(label, []).append(times)
    return Outcome(status, _normal(_MARK.sub("", of_any_python(console))), marks, end, stalled)


def _normal(text: str) -> str:
    """What differs from run to run: stamps, thread numbers, and the frames of ROS and of Python in a traceback."""
    stamp = r"\[(?:\d+\.\d{6,9}|STAMP)(, \d+\.\d{6})?\]"
    text = re.sub(stamp, lambda stamp: f"[STAMP{', ROS' if stamp[1] else ''}]", text)
    text = re.sub(r"Thread-\d+", "Thread-N", text)
    text = re.sub(r"\b0x[0-9a-f]+", "0xN", text)
    text = re.sub(r"Goal ID: \[[\d\s]+\]", "Goal ID: N", text)
    text = re.sub(r", at \S+:\d+", "", text)  # where in rcl's sources an error arose
    text = re.sub(r"^rosspin: .*\n", "", text, flags=re.M)  # who was killed, and where it waited
    # The stand-in names the line that made a timer where rospy shows only frames of its own.
    text = re.sub(r'^  File ".*, which made this timer\n(?:    .*\n)*', "", text, flags=re.M)
    text = re.sub(r"^\[['\"].*\\n['\"]\]$", _of_service, text, flags=re.M)
    text = re.sub(r"\[DEBUG\].*(init_node|bind|bound|URL|Service instance).*\n", "", text)  # of rospy's own network
    text = re.sub(r"\[DEBUG\] \[STAMP\] \[(rcl|rmw_\w+)\]: .*\n", "", text)  # of the layers below rclpy
    # The code lines and the marks below them depend on Python's version.
    text = re.sub(r'^  File ".*/scenarios\w*/(\w+\.py)", (line \d+.*)\n(?:    .*\n)*', r"  \1, \2\n", text, flags=re.M)
    text = re.sub(r'^  File ".*\n(?:    .*\n)*', "", text, flags=re.M)
    return re.sub(r"^Traceback .*\n(?!  )", "", text, flags=re.M)


def _of_service(trace: re.Match[str]) -> str:
    """What rospy logs of a service's exception: a traceback as a list, of whose frames `kept` leaves the last."""
    *frames, error = ast.literal_eval(trace[0])
    pattern = re.compile(r'  File ".*/scenarios/(\w+\.py)", (line .*)\n')
    places = [f"  {found[1]}, {found[2]}\n" for each in frames if (found := pattern.match(each))]
    return "".join([*places[-1:], error])


def differences(exact: Outcome, other: Outcome) -> list[str]:
    """What `other` has otherwise than the simulated run."""
    found = []
    if other.status != exact.status:
        found.append(f"status {other.status} for {exact.status}")
    if other.text != exact.text:
        lines = difflib.unified_diff(exact.text.splitlines(), other.text.splitlines(), "simulated", "other", n=0)
        found += [line.rstrip("\n") for line in lines]
    for label in {**exact.marks, **other.marks}:
        found += _differences(label, exact.marks.get(label, []), other.marks.get(label, []), exact.end)
    return found


def _differences(
    label: str, exact: list[list[float | None]], other: list[list[float | None]], end: float | None
) -> Iterator[str]:
    # What falls due as the scenario ends may or may not come. After Ctrl-C a real node closes its connections first,
    # and a timer may be called once more; the other marks are of the main, which is the same.
    if end == CTRL_C and len(exact[0] if exact else ()) == 1:
        end = None
    sure = [row for row in exact if end is None or _when(row) < end - TOLERANCE]
    if not len(sure) <= len(other) <= (len(exact) + 1 if end is not None else len(exact)):
        yield f"{label}: {len(other)} marks for {len(exact)}: {other} for {exact}"
    for number, (row, reference) in enumerate(zip(other, exact), 1):
        if [value is None for value in row] != [value is None for value in reference] or any(
            abs(a - b) >= TOLERANCE for a, b in zip(row, reference) if a is not None and b is not None
        ):
            yield f"{label} {number}: {row} for {reference}"


def _when(row: list[float | None]) -> float:
    """When a mark was made: the third of a timer's event's four times, or the first of its own."""
    time = row[3] if len(row) == 5 else row[0]
    assert time is not None
    return time
