"""What has never failed in a test has no race: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "Find the order in which it fails"
TEXT = """
**You need**: [Find the order in which it fails](../docs/how-to/find-the-order.rst).

Two timers call `part_callback` every 0.1 s, in two threads that may run at the same time. Each call counts one part.
Here the node reports 10 parts, each time that you run it:

```python
%%simulate 0.6
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


# The light barrier sees a part
def read_barrier():
    return 1


class PartsPyNode(Node):
    def __init__(self):
        super().__init__("parts_py_node")
        self.parts = 0
        group = ReentrantCallbackGroup()
        self.create_timer(0.1, self.part_callback, group)
        self.create_timer(0.1, self.part_callback, group)
        self.create_timer(0.55, self.report_callback, group)

    def part_callback(self):
        parts = self.parts
        self.parts = parts + read_barrier()

    def report_callback(self):
        self.get_logger().info("[PARTS] parts = " + str(self.parts))


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(PartsPyNode())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
```

On a robot it reports less, about once a week: threads 1 and 2 are both in `part_callback`, which has two lines, and
thread 1 begins. In which order do they run these so that thread 2 overwrites **the part that thread 1 counts**? Name
the thread of each line: `[1, 1, 2, 2]` means that thread 1 runs both, then thread 2. And what does the node report if
that happens once? Write `[10]` for ten parts.
"""
REVEALS = "What has never failed in a test has no race."

NODE = """
order = ...
report = ...
"""

HINTS = [
    "The first line looks the number up, the second one writes it. What has each thread looked up when it writes?",
    "Thread 2 has to write last, and to have looked before thread 1 wrote.",
    "If both look up 4, both write 5.",
]
HINT = "What has each thread looked up when it writes?"


check = predicted(
    "numbers",
    order=(
        "the order",
        [1, 2, 1, 2],
        "It has four lines: each thread runs its first line before its second one, and thread 1 begins.",
        {
            (1, 1, 2, 2): "This is the usual order: thread 2 looks up what thread 1 has written.",
            (1, 2, 2, 1): "Here thread 1 writes last, over what thread 2 has counted.",
            (2, 1, 1, 2): "Here thread 2 begins. Thread 1 runs its first line before anything else.",
            (2, 1, 2, 1): "Here thread 2 begins, and thread 1 writes last, over what thread 2 has counted.",
            (2, 2, 1, 1): "Here thread 1 looks up what thread 2 has written, and nothing is lost.",
            (1, 2): "Each thread runs two lines, so each is in the list twice.",
        },
    ),
    report=(
        "the report",
        [9],
        "Ten calls count a part each, and one of these parts is written over.",
        {
            (10,): "This is what it reports in the usual order.",
            (8,): "Two threads are in it, but only one of their two parts is lost.",
            (5,): "That is half of them: it happens once, not at each call.",
            (0,): "Only one part is lost; those before and after it stay counted.",
        },
    ),
)

SOLUTION = """
# Both look up the same number; thread 1 writes first, thread 2 writes the same over it.
order = [1, 2, 1, 2]
# One of the ten parts is lost.
report = [9]
"""
AFTER = """
On your computer, `rosspin.explore` finds that order. With a `MutuallyExclusiveCallbackGroup`, or a lock around both
lines, no order fails.
"""

RIGHT = [
    {"[1, 2, 1, 2]": "(1, 2, 1, 2)"},
    {"[1, 2, 1, 2]": "[1, 2] * 2"},
    {"[9]": "(9,)"},
    {"[9]": "[10 - 1]"},
    {"[1, 2, 1, 2]": "list((1, 2)) + [1, 2]", "[9]": "[9.0]"},
]
WRONG = [
    ({"[1, 2, 1, 2]": "[1, 1, 2, 2]"}, "the order: not 1, 1, 2, 2", "This is the usual order"),
    ({"[1, 2, 1, 2]": "[1, 2, 2, 1]"}, "the order: not 1, 2, 2, 1", "thread 1 writes last"),
    ({"[1, 2, 1, 2]": "[2, 1, 1, 2]"}, "the order: not 2, 1, 1, 2", "Here thread 2 begins"),
    ({"[1, 2, 1, 2]": "[2, 1, 2, 1]"}, "the order: not 2, 1, 2, 1", "thread 1 writes last, over what thread 2"),
    (
        {"[1, 2, 1, 2]": "[1, 2, 1, 2, 2]"},
        "4 numbers are asked for, not 5",
        "The first 4 are right, and no more are asked for",
    ),
    (
        {"[1, 2, 1, 2]": "[1, 2, 1, 1]"},
        "the fourth of these numbers is not 1",
        "each thread runs its first line before",
    ),
    ({"[1, 2, 1, 2]": "[2, 2, 1, 1]"}, "the order: not 2, 2, 1, 1", "nothing is lost"),
    ({"[1, 2, 1, 2]": "[1, 2]"}, "the order: not 1, 2", "so each is in the list twice"),
    (
        {"[1, 2, 1, 2]": "[1, 1, 1, 2]"},
        "the order: the second of these numbers is not 1",
        "each thread runs its first line before",
    ),
    ({"[9]": "[10]"}, "the report: not 10", "in the usual order"),
    ({"[9]": "[8]"}, "the report: not 8", "only one of their two parts is lost"),
    ({"[9]": "[5]"}, "the report: not 5", "not at each call"),
    ({"[9]": "[0]"}, "the report: not 0", "stay counted"),
    ({"[9]": "[11]"}, "the report: not 11", "written over"),
]
