"""A timer calls back on time, whatever its callback does: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "The ticks after a slow callback"
TEXT = """
**You need**: [what a slow callback costs](slow-callback.md), and the rule for rospy in [How timing works in ROS
1](../docs/how-timing-works.rst).

This timer's period is 0.4 s. Its third callback, due at 1.2 s, blocks for 0.6 s. The tick due at 1.6 s comes when it
has returned, at 1.8 s; those after it are on time again:

```python
%%simulate 3.0 -- _blocks_for:=0.6
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        self.blocks_for = rospy.get_param("~blocks_for")
        rospy.Timer(rospy.Duration(0.4), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))
        if self.counter == 3:
            rospy.sleep(self.blocks_for)


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
```

When do callbacks 4, 5 and 6 come if the third one blocks for 1.0 s, and for 1.8 s? Answer as in `[1.0, 2.0, 3.0]`.
"""
REVEALS = "A timer calls back on time, whatever its callback does. Ticks that are due meanwhile all wait in a queue."

NODE = """
after_1_0_seconds = ...
after_1_8_seconds = ...
"""

HINTS = [
    "The callback begins at 1.2 s. When does it return? Which ticks were due by then?",
    "No tick can come before it returns. So when does callback 4 come?",
    "rospy makes up for a tick that is late by up to two periods. If it is later, rospy counts the periods again from "
    "now, and the ticks in between are lost. How late is tick 4?",
]
HINT = "The callback ends at 1.2 s plus the time for which it blocks. Which ticks were due by then?"

_BUSY = "The slow callback keeps its timer busy until it returns: no other call of it can begin before."
_TOO_LONG = "Calls in a row follow a shorter delay. This one is too long to be made up for."

check = predicted(
    after_1_0_seconds=(
        "blocked for 1.0 s",
        [2.2, 2.2, 2.4],
        "The callback begins at 1.2 s and blocks for 1.0 s. Which ticks are overdue when it returns?",
        {
            (1.6, 2.0, 2.4): _BUSY,
            (2.2, 2.6, 3.0): "This is what roscpp does. rospy starts a new grid only after a longer delay.",
            (2.2, 2.4, 2.8): "The two ticks that were due meanwhile both come late: rospy makes up for short delays.",
        },
    ),
    after_1_8_seconds=(
        "blocked for 1.8 s",
        [3.0, 3.4, 3.8],
        "The callback begins at 1.2 s and blocks for 1.8 s. Which ticks are overdue when it returns?",
        {
            (1.6, 2.0, 2.4): _BUSY,
            (3.0, 3.0, 3.0): "This is what a queue of calls would give. There is none: ticks are lost here.",
            (3.0, 3.2, 3.6): "The timer does not go back to its old grid: after a long delay rospy begins a new one.",
            (3.0, 3.0, 3.2): _TOO_LONG,
            (3.0, 3.0, 3.4): _TOO_LONG,
        },
    ),
)

SOLUTION = """
# Tick 4 is 0.6 s late, less than 2 periods, so it is made up for:
# those due at 1.6 and 2.0 both come at 2.2.
after_1_0_seconds = [2.2, 2.2, 2.4]
# Tick 4 is 1.4 s late, more than 2 periods: the timer starts a new grid
# from the late call, and the ticks due in between are lost.
after_1_8_seconds = [3.0, 3.4, 3.8]
"""
AFTER = """
Try it: change `0.6` in the first line above your prediction.
"""

RIGHT = [
    {"[2.2, 2.2, 2.4]": "(2.2, 2.2, 2.4)"},
    {"after_1_8_seconds = [3.0, 3.4, 3.8]": "back = 1.2 + 1.8\nafter_1_8_seconds = [back + n * 0.4 for n in range(3)]"},
    {"[3.0, 3.4, 3.8]": "[3, 3.4, 3.8]"},
    {"[2.2, 2.2, 2.4]": "[2.2] * 2 + [2.4]"},
    {"[3.0, 3.4, 3.8]": "list(map(float, '3.0 3.4 3.8'.split()))"},
    {"[2.2, 2.2, 2.4]": "[2.201, 2.199, 2.4]"},
]
WRONG = [
    ({"[2.2, 2.2, 2.4]": "[1.6, 2.0, 2.4]"}, "Blocked for 1.0 s: not 1.6 s", "keeps its timer busy until it returns"),
    ({"[2.2, 2.2, 2.4]": "[2.2, 2.6, 3.0]"}, "not 2.2 s, 2.6 s, 3 s", "This is what roscpp does"),
    ({"[2.2, 2.2, 2.4]": "[2.2, 2.4, 2.8]"}, "not 2.2 s, 2.4 s", "rospy makes up for short delays"),
    (
        {"[3.0, 3.4, 3.8]": "[3.0, 3.0, 3.0]"},
        "Blocked for 1.8 s: not 3 s, 3 s, 3 s",
        "There is none: ticks are lost here",
    ),
    ({"[3.0, 3.4, 3.8]": "[3.0, 3.2, 3.6]"}, "not 3 s, 3.2 s", "rospy begins a new one"),
    ({"[3.0, 3.4, 3.8]": "[3.0, 3.0, 3.2]"}, "not 3 s, 3 s, 3.2 s", "This one is too long to be made up for"),
    ({"[3.0, 3.4, 3.8]": "[1.6, 2.0, 2.4]"}, "not 1.6 s", "keeps its timer busy"),
    (
        {"[3.0, 3.4, 3.8]": "[3.0, 3.5, 4.0]"},
        "the second of these times is not 3.5 s",
        "Which ticks are overdue when it returns?",
    ),
    ({"[3.0, 3.4, 3.8]": "[3,0 3,4 3,8]"}, "is not Python: invalid syntax", "nothing ran"),
    ({"after_1_8_seconds": "after_2_seconds"}, "there is no prediction yet", "Give `after_1_8_seconds` a list"),
    ({"[2.2, 2.2, 2.4]": "2.2"}, "not a value of type `float`", "Write it as"),
]
