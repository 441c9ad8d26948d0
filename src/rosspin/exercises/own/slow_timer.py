"""Ticks that were lost are made up for, or a timer counts on from a late call: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "When a slow timer ticks again"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md), and the rule for a timer's grid in [How timing works in ROS
2](../docs/ros2/how-timing-works.rst).

This timer's period is 0.4 s. Its third callback, due at 1.2 s, blocks for 0.6 s. The tick due at 1.6 s comes when it
has returned, at 1.8 s; those after it are on time again:

```python
%%simulate 4.0 -- --ros-args -p blocks_for:=0.6
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.blocks_for = self.declare_parameter("blocks_for", 0.6).value
        self.create_timer(0.4, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))
        if self.counter == 3:
            time.sleep(self.blocks_for)


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    try:
        rclpy.spin(spinner_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
```

When do callbacks 4, 5 and 6 come if the third one blocks for 1.0 s, and for 1.8 s? Answer as in `[1.0, 2.0, 3.0]`.

Now *each* callback takes 0.6 s. When do callbacks 1, 2 and 3 come?
"""
REVEALS = "Ticks that were lost are made up for, or a timer counts on from a late call."

NODE = """
after_1_0_seconds = ...
after_1_8_seconds = ...
always_slow = ...
"""

HINTS = [
    "The callback begins at 1.2 s. When does it return? No call can begin before that.",
    "The grid is 0.4, 0.8, 1.2 and so on, whatever happens. If times of it have passed when a callback returns, one "
    "call comes immediately, however many they are. The next one waits for the grid.",
    "If each callback takes 0.6 s, which tick is overdue when the first one returns, at 1.0 s?",
]
HINT = (
    "When does the callback return? Which tick is overdue then, and which is the next place of the grid 0.4, 0.8, 1.2?"
)

_BUSY = "While the callback runs, the executor calls nothing: no other call can begin before it returns."
_ONE_TICK = "However many ticks are overdue when the callback returns, one of them comes immediately, and no more."
_GRID = "The timer does not count from the call that came late: it goes back to its grid."

check = predicted(
    after_1_0_seconds=(
        "blocked for 1.0 s",
        [2.2, 2.4, 2.8],
        "The callback begins at 1.2 s and blocks for 1.0 s. Which ticks are overdue when it returns?",
        {
            (1.6, 2.0, 2.4): _BUSY,
            (2.2, 2.2, 2.4): _ONE_TICK,
            (2.2, 2.6, 3.0): _GRID,
            (2.4, 2.8, 3.2): "One tick is overdue when the callback returns, and it comes immediately.",
        },
    ),
    after_1_8_seconds=(
        "blocked for 1.8 s",
        [3.0, 3.2, 3.6],
        "The callback begins at 1.2 s and blocks for 1.8 s. Which ticks are overdue when it returns?",
        {
            (1.6, 2.0, 2.4): _BUSY,
            (3.0, 3.4, 3.8): _GRID,
            (3.0, 3.0, 3.0): "There is no queue of calls. However many ticks are overdue, one of them comes.",
            (3.2, 3.6, 4.0): "One overdue tick still comes, as soon as the callback returns.",
        },
    ),
    always_slow=(
        "each callback takes 0.6 s",
        [0.4, 1.0, 1.6],
        "A callback that begins at 0.4 s returns at 1.0 s. Which tick is overdue then?",
        {
            (0.4, 0.8, 1.2): _BUSY,
            (0.4, 1.2, 2.0): "When the callback returns, a tick is overdue, and it does not wait any longer.",
            (0.4, 1.4, 2.4): "The timer does not count from the end of a callback.",
        },
    ),
)

SOLUTION = """
# Back at 2.2: the tick of 1.6 comes immediately, the one at 2.0 is lost,
# and the next place of the grid is 2.4.
after_1_0_seconds = [2.2, 2.4, 2.8]
# Back at 3.0: one overdue tick comes immediately, the others are lost.
after_1_8_seconds = [3.0, 3.2, 3.6]
# Each time, a tick is overdue when the callback returns.
always_slow = [0.4, 1.0, 1.6]
"""
AFTER = """
Try it above your prediction: change `blocks_for:=0.6` in the first line to `1.0` and to `1.8`; then back to 0.6, and
`self.counter == 3` to `self.counter >= 1`. In the plot, a cross marks each tick that was lost. ROS 1 differs: see *The
ticks after a slow callback*, one of the [exercises on ROS 1](exercises.md).
"""

RIGHT = [
    {"[2.2, 2.4, 2.8]": "(2.2, 2.4, 2.8)"},
    {"[3.0, 3.2, 3.6]": "[3, 3.2, 3.6]"},
    {"[0.4, 1.0, 1.6]": "[0.4 + 0.6 * n for n in range(3)]"},
    {"[0.4, 1.0, 1.6]": "(0.4, 1, 1.6)"},
    {"[2.2, 2.4, 2.8]": "[2.2, 2.4, 2.8]\nprint(after_1_0_seconds)"},
]
WRONG = [
    (
        {"[2.2, 2.4, 2.8]": "[2.2, 2.2, 2.4]"},
        "Blocked for 1.0 s: not 2.2 s, 2.2 s",
        "one of them comes immediately, and",
    ),
    ({"[2.2, 2.4, 2.8]": "[2.2, 2.6, 3.0]"}, "Blocked for 1.0 s: not 2.2 s, 2.6 s", "it goes back to its grid"),
    ({"[2.2, 2.4, 2.8]": "[1.6, 2.0, 2.4]"}, "not 1.6 s", "the executor calls nothing"),
    ({"[2.2, 2.4, 2.8]": "[2.4, 2.8, 3.2]"}, "not 2.4 s", "it comes immediately"),
    ({"[3.0, 3.2, 3.6]": "[3.0, 3.4, 3.8]"}, "Blocked for 1.8 s: not 3 s, 3.4 s", "it goes back to its grid"),
    ({"[3.0, 3.2, 3.6]": "[3.0, 3.0, 3.0]"}, "not 3 s, 3 s, 3 s", "There is no queue of calls"),
    ({"[3.0, 3.2, 3.6]": "[3.2, 3.6, 4.0]"}, "not 3.2 s", "One overdue tick still comes"),
    ({"[0.4, 1.0, 1.6]": "[0.4, 1.2, 2.0]"}, "Each callback takes 0.6 s: not 0.4 s, 1.2 s", "does not wait any longer"),
    ({"[0.4, 1.0, 1.6]": "[0.4, 1.4, 2.4]"}, "not 0.4 s, 1.4 s", "does not count from the end"),
    ({"[0.4, 1.0, 1.6]": "[0.4, 1.1, 1.8]"}, "the second of these times is not 1.1 s", "Which tick is overdue then?"),
    ({"[0.4, 1.0, 1.6]": "None"}, "Each callback takes 0.6 s: there is no prediction yet", "Give `always_slow`"),
    ({"[2.2, 2.4, 2.8]": "2.2"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
]
