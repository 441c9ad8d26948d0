"""A timer calls back by itself, whether the node spins or not: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "Who calls the callback"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md).

This node's callback is called every 0.4 s. Its traceback comes from Ctrl-C, which ends each simulated run.

```python
%%simulate 2.0
import time

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


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    rclpy.spin(spinner_py_node)


if __name__ == '__main__':
    main()
```

Now replace `rclpy.spin(spinner_py_node)`, first by a loop that never spins:

```python
    while rclpy.ok():
        time.sleep(0.1)
```

Then by one call of `spin_once` before that loop:

```python
    rclpy.spin_once(spinner_py_node)
    while rclpy.ok():
        time.sleep(0.1)
```

When do callbacks come in the first 2 s? List their times, as in `[1.0, 2.0]`; `[]` means none.
"""
REVEALS = "A timer calls back by itself, whether the node spins or not."

NODE = """
without_spin = ...
spin_once = ...
"""

HINTS = [
    "The timer knows when it is due. Does that alone call a function?",
    "A timer of ROS 2 has no thread of its own: the thread that spins calls the callbacks.",
    "`spin_once` waits until something is due, calls one callback, and returns.",
]
HINT = "In ROS 2 a timer has no thread of its own. Who calls the callback?"

_ONE_CALL = "`spin_once` starts nothing: it calls one callback, and returns."

check = predicted(
    without_spin=(
        "without spin",
        [],
        "A timer of ROS 2 has no thread of its own. Its callback is called by the thread that spins.",
        {
            (0.4, 0.8, 1.2, 1.6, 2.0): "",
            (0.4, 0.8, 1.2): "",
        },
    ),
    spin_once=(
        "with one `spin_once`",
        [0.4],
        "`spin_once` waits until something is due. Then it calls it.",
        {
            (): "`spin_once` waits until something is due, and calls one callback.",
            (0.0,): "Nothing is due at the start. `spin_once` waits until something is.",
            (0.4, 0.8, 1.2, 1.6, 2.0): _ONE_CALL,
            (0.4, 0.8, 1.2): _ONE_CALL,
        },
    ),
)

SOLUTION = """
# Only spin calls callbacks.
without_spin = []
# It calls one callback and returns.
spin_once = [0.4]
"""
AFTER = """
Try it in the node above your prediction.
"""

RIGHT = [
    {"[]": "()"},
    {"[]": "list()\nprint(without_spin)"},
    {"[0.4]": "(0.4,)"},
    {"[0.4]": "[2 / 5]"},
    {"[0.4]": "[.4]", "[]": "[]  # nothing spins"},
]
WRONG = [
    ({"[]": "[0.4, 0.8, 1.2]"}, "Without spin: not 0.4 s", "has no thread of its own"),
    ({"[]": "[0.4, 0.8, 1.2, 1.6, 2.0]"}, "Without spin: not 0.4 s", "called by the thread that spins"),
    ({"[]": "[0.0]"}, "Without spin: not 0 s", "called by the thread that spins"),
    ({"[]": "[0.1, 0.2]"}, "Without spin: not 0.1 s", "has no thread of its own"),
    ({"[0.4]": "[]"}, "With one `spin_once`: not nothing at all", "waits until something is due"),
    ({"[0.4]": "[0.0]"}, "With one `spin_once`: not 0 s", "Nothing is due at the start"),
    ({"[0.4]": "[0.4, 0.8, 1.2, 1.6, 2.0]"}, "With one `spin_once`: not 0.4 s, 0.8 s", "starts nothing"),
    ({"[0.4]": "[0.4, 0.8, 1.2]"}, "With one `spin_once`: not 0.4 s, 0.8 s", "starts nothing"),
    ({"[0.4]": "[0.5]"}, "With one `spin_once`: not 0.5 s", "Then it calls it"),
    ({"[]": "None"}, "Without spin: there is no prediction yet", "Give `without_spin`"),
    ({"[0.4]": "0.4"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
]
