"""A timer calls back immediately: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "The first ticks"
TEXT = """
**You need**: [the timer node](timer.md) and [the Rate node](rate.md).

When does this node print counters 1, 2 and 3, in seconds since its start? Answer as in `[1.0, 2.0, 3.0]`.

```python
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        rospy.Timer(rospy.Duration(0.4), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))


rospy.init_node("spinner_py_node")
spinner_py_node = SpinnerPyNode()
rospy.spin()
```

And this one?

```python
import rospy

rospy.init_node("spinner_py_node")
loop_rate = rospy.Rate(4)
counter = 0
while not rospy.is_shutdown():
    counter += 1
    rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))
    loop_rate.sleep()
```

And with `rospy.sleep(0.1)`, some work, between its last two lines?
"""
REVEALS = "A timer calls back immediately. A duration is a frequency. A rate sleeps for a whole period after the work."

NODE = """
timer = ...
loop = ...
busy_loop = ...
"""

HINTS = [
    "A `rospy.Duration` is in seconds. A `rospy.Rate` takes a frequency: 4 Hz is 4 passes a second.",
    "What does the loop do before it first sleeps?",
    "`loop_rate.sleep()` sleeps until the next period begins. How long is that after 0.1 s of work?",
]
HINT = "When does the first tick come: at the start, or one period later? How far apart are the ticks?"

_IN_HZ = "This mistakes 0.4 for a frequency. A timer takes a period, in seconds."
_FIRST_PASS = "A loop makes its first pass immediately; `rate.sleep()` comes at the end of a pass."
_IN_SECONDS = "This mistakes 4 for a period. A rate takes a frequency, in Hz."

check = predicted(
    timer=(
        "the timer",
        [0.4, 0.8, 1.2],
        "A `rospy.Duration` is a time in seconds. Does a timer call back before it has waited?",
        {
            (0.0, 0.4, 0.8): "A timer waits for one period before its first call.",
            (2.5, 5.0, 7.5): _IN_HZ,
            (0.0, 2.5, 5.0): _IN_HZ,
        },
    ),
    loop=(
        "the loop",
        [0.0, 0.25, 0.5],
        "4 Hz is 4 passes a second. What does the loop do before it sleeps for the first time?",
        {
            (0.25, 0.5, 0.75): _FIRST_PASS,
            (0.0, 4.0, 8.0): _IN_SECONDS,
            (4.0, 8.0, 12.0): _IN_SECONDS,
        },
    ),
    busy_loop=(
        "the loop with 0.1 s of work",
        [0.0, 0.25, 0.5],
        "`rate.sleep()` sleeps until the next period begins. How long is that after 0.1 s of work?",
        {
            (0.25, 0.5, 0.75): _FIRST_PASS,
            (0.0, 0.35, 0.7): "`rate.sleep()` sleeps until the next period begins: the work is a part of the period.",
            (0.1, 0.35, 0.6): "This is when the work ends. The counter is printed before it.",
            (0.1, 0.45, 0.8): "The counter is printed before the work, and the work is a part of the period.",
        },
    ),
)

SOLUTION = """
# A timer waits for one period before its first call.
timer = [0.4, 0.8, 1.2]
# A loop makes its first pass immediately.
loop = [0.0, 0.25, 0.5]
# The work is a part of the period: sleep() sleeps for the rest, 0.15 s.
busy_loop = [0.0, 0.25, 0.5]
"""

# What stands for numpy's arrays and their numbers, which a page lacks.
ARRAY = """class Array:
    def __init__(self, value):
        self.value = value
    def tolist(self):
        return self.value
"""

RIGHT = [
    {"[0.4, 0.8, 1.2]": "(0.4, 0.8, 1.2)"},
    {
        "[0.4, 0.8, 1.2]": "[0.4 * n for n in range(1, 4)]",
        "\nloop = [0.0, 0.25, 0.5]": "\nloop = [n / 4 for n in range(3)]",
    },
    {"[0.4, 0.8, 1.2]": "[n * 0.4 for n in (1, 2, 3)]"},
    {"busy_loop = [0.0, 0.25, 0.5]": "busy_loop = loop"},
    {"timer = [0.4, 0.8, 1.2]": "from fractions import Fraction\ntimer = [float(Fraction(n, 5)) for n in (2, 4, 6)]"},
    {"\nloop = [0.0, 0.25, 0.5]": "\nloop = [0, .25, .5]\nprint(loop)"},
    {"timer = [0.4, 0.8, 1.2]": "from fractions import Fraction\ntimer = [Fraction(n, 5) for n in (2, 4, 6)]"},
    {"\nloop = [0.0, 0.25, 0.5]": "\nfrom decimal import Decimal\nloop = [n * Decimal('0.25') for n in range(3)]"},
    {"timer = [0.4, 0.8, 1.2]": "class A(float):\n    pass\ntimer = [A(0.4), 0.8, 1.2]"},
    {
        "timer = [0.4, 0.8, 1.2]": "import numpy\ntimer = 0.4 * numpy.arange(1, 4)",
        "\nloop = [0.0, 0.25, 0.5]": "\nloop = list(timer / timer[0] / 4 - 0.25)",
    },
    {"timer = [0.4, 0.8, 1.2]": f"{ARRAY}timer = Array([0.4, 0.8, 1.2])"},
    {"timer = [0.4, 0.8, 1.2]": f"{ARRAY}timer = [Array(0.4), Array(0.8), 1.2]"},
]
WRONG = [
    (
        {"[0.4, 0.8, 1.2]": "[0.0, 0.4, 0.8]"},
        "The timer: not 0 s, 0.4 s, 0.8 s",
        "A timer waits for one period before its first call",
    ),
    ({"[0.4, 0.8, 1.2]": "[2.5, 5, 7.5]"}, "The timer: not 2.5 s", "This mistakes 0.4 for a frequency"),
    (
        {"\nloop = [0.0, 0.25, 0.5]": "\nloop = [0.25, 0.5, 0.75]"},
        "The loop: not 0.25 s",
        "makes its first pass immediately",
    ),
    (
        {"\nloop = [0.0, 0.25, 0.5]": "\nloop = [0, 4, 8]"},
        "The loop: not 0 s, 4 s, 8 s",
        "This mistakes 4 for a period",
    ),
    (
        {"busy_loop = [0.0, 0.25, 0.5]": "busy_loop = [0, 0.35, 0.7]"},
        "not 0 s, 0.35 s, 0.7 s",
        "the work is a part of the period",
    ),
    ({"busy_loop = [0.0, 0.25, 0.5]": "busy_loop = [0.1, 0.35, 0.6]"}, "not 0.1 s", "This is when the work ends"),
    ({"[0.4, 0.8, 1.2]": "[0.4, 0.8]"}, "3 times are asked for, not 2", "These are right, and one more is asked for"),
    ({"[0.4, 0.8, 1.2]": "'0.4, 0.8, 1.2'"}, "not a value of type `str`", "Write it as `[1.0, 2.0, 3.0]`"),
    (
        {"\nloop = [0.0, 0.25, 0.5]": "\nloop = ..."},
        "The loop: there is no prediction yet",
        "Give `loop` a list of times",
    ),
    ({"[0.4, 0.8, 1.2]": "[0.4, 0.9, 1.2]"}, "the second of these times is not 0.9 s", "Does a timer call back before"),
    ({"[0.4, 0.8, 1.2]": "[period]"}, "stopped in line 2: `NameError: name 'period'", "Python names what it did"),
    ({"[0.4, 0.8, 1.2]": "range(10**9)"}, "3 times are asked for, not 100", "Does a timer call"),
    (
        {"timer = [0.4, 0.8, 1.2]": "class A(list):\n    pass\ntimer = A([0.4, 0.8, 1.2])"},
        "a value of type `A`",
        "Write it as",
    ),
    ({"[0.4, 0.8, 1.2]": "[True, 0.8, 1.2]"}, "not one that holds something else", "Write it as"),
    (
        {"timer = [0.4, 0.8, 1.2]": f"{ARRAY}timer = Array(['0.4', '0.8', '1.2'])"},
        "a value of type `Array`",
        "Write it as",
    ),
]
