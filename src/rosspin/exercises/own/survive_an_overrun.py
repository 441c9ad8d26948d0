"""A pass that was lost has to be made up for: a belief that this reveals."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import pairwise

from .. import judges as by
from ..judging import Judge
from ..observed import Printed
from ..odd_nodes import HEAD, say

TITLE = "Survive an overrun"
TEXT = """
**You need**: [the Rate node](rate.md) and [what drifts, and why](drift.md).

Without a `Rate`, this loop sleeps until a deadline for each pass, on a [grid](../docs/glossary.rst#term-grid) of 0.5 s.
But its third pass works for longer than a period, and the node stops with an error.

Make it survive without making up for lost passes: after the overrun it continues at the next time on the grid 0, 0.5,
1.0, … s.
"""
REVEALS = "A pass that was lost has to be made up for. After an overrun one may count on from now."

NODE = """
import time

import rospy


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    work = rospy.get_param("~work")
    period = 0.5
    deadline = time.monotonic()
    counter = 0
    while not rospy.is_shutdown():
        counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
        if counter == 3:
            rospy.sleep(work)
        deadline += period
        time.sleep(deadline - time.monotonic())
"""

HINTS = [
    "What is `deadline - time.monotonic()` after a pass of 0.7 s? What does `time.sleep` say to that?",
    "If it sleeps for 0 s instead, it makes up for the lost pass.",
    "Move the deadline by whole periods until it is ahead of now.",
]
HINT = "Before the loop sleeps, move the deadline on by whole periods until it lies ahead."


def _overrun(work: float, counters: Sequence[Printed]) -> str:
    """Return a hint on a loop of 2 Hz whose third pass works for too long (s)."""
    if len(counters) > 3 and counters[3].time - counters[2].time < work - by.CLOSE:
        return f"The third pass works for {work:g} s: leave that in it. The next one begins after it."
    if counters and abs(counters[-1].time / 0.5 - round(counters[-1].time / 0.5)) > by.CLOSE:
        return "The loop has left its grid of 0.5 s: count deadlines on from the old one, not from now."
    if any(after.time - line.time < 0.5 - by.CLOSE for line, after in pairwise(counters[2:])):
        return "A lost pass is not to be made up for: two passes in a row would send two commands in quick succession."
    return ""


def _resumes(start: float, work: str) -> Judge:
    """After a third pass of so much work (s), the loop is on its grid again from a time (s) on."""
    ticks = by.ticks(0.5, at=[0.0, 0.5, 1.0], start=start, hint=partial(_overrun, float(work)))
    return by.run(5.0, ticks, given=f"_work:={work}")


check = by.every(_resumes(2.0, "0.7"), _resumes(3.0, "1.7"), _resumes(3.5, "2.3"), _resumes(1.5, "0.1"))

SOLUTION = {
    "        deadline += period\n": (
        "        deadline += period\n        while deadline < time.monotonic():\n            deadline += period\n"
    )
}

WHILE_LATE = "        while deadline < time.monotonic():\n            deadline += period\n"
SLEEP = "        time.sleep(deadline - time.monotonic())"


def overrun(after: str, before: str = "") -> str:
    """A loop, with what comes after its work."""
    lines = "\n".join(f"    {line}" for line in after.splitlines())
    return f"""import math, time
{HEAD}work = rospy.get_param("~work")
start = deadline = time.monotonic()
count = 0
{before}
while not rospy.is_shutdown():
    count += 1
    {say("count")}
    if count == 3:
        rospy.sleep(work)
{lines}
"""


RIGHT = [
    overrun(
        "deadline += 0.5\nwhile deadline <= time.monotonic() - 1e-9:\n    deadline += 0.5\n"
        "time.sleep(max(0, deadline - time.monotonic()))"
    ),
    overrun("now = time.monotonic() - start\nrospy.sleep((math.floor(now / 0.5 + 1e-6) + 1) * 0.5 - now)"),
    overrun("rospy.sleep(0.5 - (time.monotonic() - start) % 0.5)"),
    overrun(
        "late = time.monotonic() - deadline\ndeadline += max(1, math.ceil(late / 0.5)) * 0.5\n"
        "rospy.sleep(deadline - time.monotonic())"
    ),
    overrun(
        "deadline = deadline + 0.5\nif deadline < time.monotonic():\n    rospy.logwarn('late')\n"
        "    deadline += math.ceil((time.monotonic() - deadline) / 0.5) * 0.5\n"
        "time.sleep(deadline - time.monotonic())"
    ),
    overrun(
        "try:\n    deadline += 0.5\n    time.sleep(deadline - time.monotonic())\n"
        "except ValueError:\n    rospy.logerr('late', exc_info=True)\n"
        "    while deadline < time.monotonic():\n        deadline += 0.5\n"
        "    time.sleep(deadline - time.monotonic())"
    ),
]
WRONG = [
    (
        {WHILE_LATE: "", SLEEP: f"        try:\n    {SLEEP}\n        except ValueError:\n            pass"},
        "counter 4 came at 1.7 s, not at 2 s",
        "would send two commands in quick succession",
    ),
    (
        {WHILE_LATE: "", "time.sleep(deadline - time.monotonic())": "rospy.sleep(deadline - time.monotonic())"},
        "With `_work:=1.7`: counter 4 came at 2.7 s, not at 3 s",
        "two commands in quick succession",
    ),
    (
        {WHILE_LATE: "", "deadline += period": "deadline = time.monotonic() + period"},
        "counter 4 came at 2.2 s",
        "count deadlines on from the old one",
    ),
    ({WHILE_LATE: "", SLEEP: "        rospy.sleep(period)"}, "counter 4 came at 2.2 s", "has left its grid"),
    (
        {WHILE_LATE: "        if deadline < time.monotonic():\n            deadline = time.monotonic() + 0.3\n"},
        "With `_work:=2.3`: counter 4 came at 3.6 s, not at 3.5 s",
        "has left its grid",
    ),
    ({WHILE_LATE: ""}, "stopped in line 18: `ValueError: sleep length must be", "move the deadline on"),
    (overrun("rate.sleep()", "rate = rospy.Rate(2)"), "counter 4 came at 1.7 s", "two commands in quick"),
    (
        {WHILE_LATE: "        if deadline < time.monotonic():\n            deadline += period\n"},
        "Started with `_work:=1.7`, the node stopped in line 20: `ValueError",
        "move the deadline on",
    ),
    (
        {WHILE_LATE: "        if deadline < time.monotonic():\n            deadline = time.monotonic()\n"},
        "counter 4 came at 1.7 s",
        "has left its grid",
    ),
    (
        {"            rospy.sleep(work)": "            pass"},
        "counter 4 came at 1.5 s, not at 2 s",
        "leave that in it",
    ),
    (
        {WHILE_LATE: "        while deadline < time.monotonic():\n            pass\n"},
        "stands still",
        "without ever sleeping",
    ),
]
