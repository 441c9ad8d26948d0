"""A timer calls back immediately: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "When the first call comes"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md).

When does this node print counters 1, 2 and 3, in seconds since its start? Answer as in `[1.0, 2.0, 3.0]`.

```python
import rclpy
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.create_timer(0.4, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))


rclpy.init()
rclpy.spin(SpinnerPyNode())
```

And this one, which has a loop instead?

```python
import time

import rclpy
from rclpy.node import Node

rclpy.init()
node = Node("spinner_py_node")
counter = 0
while rclpy.ok():
    counter += 1
    node.get_logger().info("[SPINNER PY NODE] counter = " + str(counter))
    time.sleep(0.4)
```
"""
REVEALS = "A timer calls back immediately."

NODE = """
timer = ...
loop = ...
"""

HINTS = [
    "What does the loop do before it first sleeps?",
    "Does a timer call back before it has waited?",
    "A timer calls back one period after it was made, and then once each period.",
]
HINT = "Does a timer call back before it has waited? What does the loop do before it sleeps?"

_IN_HZ = "This mistakes the number for a frequency. `create_timer` takes a period, in seconds."

check = predicted(
    timer=(
        "the timer",
        [0.4, 0.8, 1.2],
        "`create_timer(0.4, ...)` waits for 0.4 s from one call to the next. And before the first one?",
        {
            (0.0, 0.4, 0.8): "A timer waits for one period before its first call.",
            (2.5, 5.0, 7.5): _IN_HZ,
            (0.0, 2.5, 5.0): _IN_HZ,
        },
    ),
    loop=(
        "the loop",
        [0.0, 0.4, 0.8],
        "Follow it line by line. What does it do before it sleeps for the first time?",
        {(0.4, 0.8, 1.2): "A loop makes its first pass immediately; it sleeps at the end of a pass."},
    ),
)

SOLUTION = """
# A timer waits for one period before its first call.
timer = [0.4, 0.8, 1.2]
# A loop makes its first pass immediately.
loop = [0.0, 0.4, 0.8]
"""
AFTER = """
To do something immediately and then each period, call the callback yourself, once, after making the timer.
"""

RIGHT = [
    {"[0.4, 0.8, 1.2]": "(0.4, 0.8, 1.2)"},
    {"[0.4, 0.8, 1.2]": "[0.4 * n for n in range(1, 4)]"},
    {"[0.0, 0.4, 0.8]": "[0, .4, .8]"},
    {"[0.0, 0.4, 0.8]": "list((0.0, 0.4, 0.8))"},
    {"[0.0, 0.4, 0.8]": "[0.0, 0.4, 0.8]\nprint(loop)"},
]
WRONG = [
    (
        {"[0.4, 0.8, 1.2]": "[0.0, 0.4, 0.8]"},
        "The timer: not 0 s, 0.4 s, 0.8 s",
        "waits for one period before its first",
    ),
    ({"[0.4, 0.8, 1.2]": "[2.5, 5.0, 7.5]"}, "The timer: not 2.5 s", "mistakes the number for a frequency"),
    ({"[0.4, 0.8, 1.2]": "[0.0, 2.5, 5.0]"}, "The timer: not 0 s, 2.5 s", "mistakes the number for a frequency"),
    ({"[0.4, 0.8, 1.2]": "[0.4, 0.8, 1.3]"}, "the third of these times is not 1.3 s", "And before the first one?"),
    ({"[0.4, 0.8, 1.2]": "[400, 800, 1200]"}, "not 400 s", "These are milliseconds"),
    ({"[0.4, 0.8, 1.2]": "[0.4, 0.8, 1.2, 1.6]"}, "3 times are asked for, not 4", "The first 3 are right"),
    ({"[0.4, 0.8, 1.2]": "[0.4, 0.8]"}, "3 times are asked for, not 2", "These are right, and one more is asked for"),
    ({"[0.0, 0.4, 0.8]": "[0.4, 0.8, 1.2]"}, "The loop: not 0.4 s", "makes its first pass immediately"),
    ({"[0.0, 0.4, 0.8]": "[0.0, 0.5, 1.0]"}, "the second of these times is not 0.5 s", "Follow it line by line"),
    ({"[0.0, 0.4, 0.8]": "0.4"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
    ({"[0.0, 0.4, 0.8]": "..."}, "The loop: there is no prediction yet", "Give `loop`"),
]
