"""A late tick is a missing one: a belief that this reveals."""

from __future__ import annotations

from collections.abc import Sequence

from .. import judges as by
from ..feedback import Finding
from ..judging import Judge, plain
from ..observed import ObservedRun

TITLE = "Count the ticks that are missing"
TEXT = """
**You need**: [what a slow callback costs](slow-callback.md) and [How timing works in ROS
1](../docs/how-timing-works.rst).

In each callback, print how many ticks are missing: how many others were due before now and have not been called, 0 if
all is on time. Of `event`, `current_expected` is when this tick was due, and `current_real` when it came.
"""
REVEALS = "A late tick is a missing one. What a timer event says is the same in rospy and roscpp."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        self.blocks_for = rospy.get_param("~blocks_for")
        rospy.Timer(rospy.Duration(0.4), self.timerCallback)

    def timerCallback(self, event):
        missing = 0
        rospy.loginfo("[SPINNER PY NODE] missing = " + str(missing))
        self.counter += 1
        if self.counter == 3:
            rospy.sleep(self.blocks_for)


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
"""

HINTS = [
    "How late is this call? The two times differ by a `Duration`.",
    "How many whole periods fit into `duration.to_sec()`?",
    "Round down: a tick that is late by less than a period leaves none missing.",
]
HINT = "`event.current_real - event.current_expected` is how late this call is. How many whole periods is that?"


def _missing(blocks_for: str, wanted: Sequence[int]) -> Judge:
    """Whether each callback printed how many ticks were missing."""

    def look(run: ObservedRun, when: str) -> Finding:
        found = [line for line in run.values("[^]]*", "missing") if line.time <= run.seconds]
        if not found:
            return Finding(False, f"{when}: no line with `missing = ` was printed.")
        if len(found) != len(wanted):
            return Finding(False, f"{when}: {len(wanted)} callbacks printed {len(found)} lines with `missing = `.")
        for number, (line, due) in enumerate(zip(found, wanted, strict=True), 1):
            said = by.as_number(line.text)
            if said != due:
                whole = said is not None and said == int(said)
                hint = "" if whole else "A tick is either missing or not: the number is whole."
                were = "was" if due == 1 else "were"
                text = f"{when}: callback {number} printed `missing = {plain(line.text)}`, but {due} {were} missing."
                return Finding(False, text, hint)
        return Finding(True, f"{when}: the callbacks printed {', '.join(line.text for line in found)}.")

    return by.run(5.0, look, given=f"_blocks_for:={blocks_for}")


check = by.every(
    _missing("1.8", [0, 0, 0, 3, 3, 3, 3, 3, 3]),
    _missing("1.0", [0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0]),
    _missing("0.7", [0] * 12),
)

SOLUTION = {
    "        missing = 0\n": (
        "        lateness = event.current_real - event.current_expected\n"
        "        missing = int(lateness.to_sec() / 0.4)\n"
    )
}
AFTER = """
rospy never corrects `current_expected`: once ticks are lost, every later call counts as late. roscpp corrects it when
it starts a new grid, so there the same calculation prints 0. In C++, compare `current_real` with `last_real`.
"""

MISSING = "missing = int(lateness.to_sec() / 0.4)"
WHOLE = "the number is whole"

RIGHT = [
    {MISSING: "missing = float(int(lateness.to_sec() / 0.4))"},
    {MISSING: "missing = lateness // rospy.Duration(0.4)"},
    {MISSING: "missing = int(lateness.to_nsec() // 400000000)"},
    {"= event.current_real -": "= rospy.Time.now() -"},
    {MISSING: "missing = 0\n        while (missing + 1) * 0.4 <= lateness.to_sec():\n            missing += 1"},
    {MISSING: "import math\n        missing = math.floor(lateness.to_sec() / 0.4)"},
    {'rospy.loginfo("[SPINNER PY NODE] missing = " + str(missing))': 'print(f"[LATE] missing = {missing}")'},
]
WRONG = [
    ({MISSING: "missing = lateness.to_sec()"}, "printed `missing = 1.4`, but 3 were missing", WHOLE),
    (
        {MISSING: "missing = round(lateness.to_sec() / 0.4)"},
        "printed `missing = 1`, but 0 were",
        "How many whole periods",
    ),
    ({"event.current_expected": "event.last_real"}, "stopped in line 11: `TypeError", "how late this call is"),
    (
        {'"[SPINNER PY NODE] missing = "': '"missing: "'},
        "no line with `missing = ` was printed",
        "how late this call",
    ),
    (
        {MISSING: "missing = int(lateness.to_sec() > 0.4)"},
        "printed `missing = 1`, but 3 were missing",
        "How many whole",
    ),
    (
        {MISSING: "missing = lateness"},
        "printed `missing = 1400000000`, but 3 were missing",
        "How many whole periods",
    ),
    (
        {MISSING: "missing = int(lateness.to_sec() / 0.5)"},
        "printed `missing = 2`, but 3 were missing",
        "How many whole",
    ),
    ({MISSING: "missing = 'none'"}, "printed `missing = none`, but 0 were missing", WHOLE),
    (
        {"            rospy.sleep(self.blocks_for)": "            pass"},
        "callbacks printed 12 lines",
        "how late this call",
    ),
    (
        {MISSING: "missing = int(lateness.to_sec() / 0.4)\n        if not missing: return"},
        "no line with `missing = `",
        "how late",
    ),
]
