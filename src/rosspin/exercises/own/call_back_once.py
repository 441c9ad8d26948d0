"""A timer stops when its callback returns early: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Call back once"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md).

This node should do something **once**, 1.5 s after it starts, but its timer fires again and again. Stop that timer
after its first call, and keep the heartbeat. In ROS 2, `create_timer` has no `oneshot`.
"""
REVEALS = "A timer stops when its callback returns early. `rclpy.shutdown()` stops a timer."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.beats = 0
        self.create_timer(1.5, self.timer_callback)
        self.create_timer(1.0, self.heartbeat_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))

    def heartbeat_callback(self):
        self.beats += 1
        self.get_logger().info("[HEARTBEAT] counter = " + str(self.beats))


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
"""

HINTS = [
    "`create_timer` returns the timer. Keep it.",
    "A timer has a method `cancel()`.",
    "Call `self.timer.cancel()` in the callback.",
]
_STOPS_ALL = "Stop one timer, and no more: what ends the node, or keeps its callback from returning, stops them all."
HINT = "Keep the timer in `self.timer`, and call its `cancel()` in the callback."

check = by.run(
    6.0,
    by.ticks(at=[1.5]),
    by.ticks(1.0, "The heartbeat", "HEARTBEAT", _STOPS_ALL),
    by.stops(1, "a timer of the node"),
)

SOLUTION = {
    "self.create_timer(1.5": "self.timer = self.create_timer(1.5",
    "    def timer_callback(self):\n": "    def timer_callback(self):\n        self.timer.cancel()\n",
}
AFTER = """
`self.timer.reset()` starts a cancelled timer again. `self.destroy_timer(self.timer)` removes it.
"""

SAYS = '        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))\n'
CANCELS = "        self.timer.cancel()\n"
KEEPS = "self.timer = self.create_timer(1.5, self.timer_callback)"
SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"

RIGHT = [
    {CANCELS + "        self.counter += 1\n" + SAYS: "        self.counter += 1\n" + SAYS + CANCELS},
    {CANCELS: "        self.destroy_timer(self.timer)\n"},
    {CANCELS: "        self.timer.destroy()\n"},
    # The heartbeat cancels it.
    {
        CANCELS: "",
        "        self.beats += 1\n": "        self.beats += 1\n        if self.beats == 2: self.timer.cancel()\n",
    },
    {KEEPS: "self.timer = self.create_timer(1.5, lambda: self.timer_callback())"},
    {KEEPS: "self.timer = self.create_timer(timer_period_sec=1.5, callback=self.timer_callback)"},
    {TRY: "    rclpy.spin(spinner_py_node)\n"},
    {TRY: "    while rclpy.ok():\n        rclpy.spin_once(spinner_py_node)\n"},
    {
        "import ExternalShutdownException": "import ExternalShutdownException, SingleThreadedExecutor",
        SPIN: "        executor = SingleThreadedExecutor()\n        executor.add_node(spinner_py_node)\n"
        "        executor.spin()\n",
    },
    {
        "import ExternalShutdownException": "import ExternalShutdownException, MultiThreadedExecutor",
        SPIN: "        executor = MultiThreadedExecutor()\n        executor.add_node(spinner_py_node)\n"
        "        executor.spin()\n",
    },
    {TRY: "    try:\n        rclpy.spin(spinner_py_node)\n    finally:\n        rclpy.shutdown()\n"},
]
WRONG = [
    ({CANCELS: "        del self.timer\n"}, "object has no attribute 'timer'", "before this line runs"),
    ({KEEPS: KEEPS.replace(")", ", autostart=False)")}, "no counter was printed", "or never started"),
    (
        {CANCELS: "        if self.counter:\n            return\n"},
        "the callback was called 4 times in 6 s",
        "A callback that returns immediately is still called",
    ),
    (
        {CANCELS: "        rclpy.shutdown()\n"},
        "The heartbeat: counter 2, due at 2 s",
        "Stop one timer, and no more",
    ),
    ({CANCELS: "        raise SystemExit\n"}, "The heartbeat: counter 2, due", "what ends the node"),
    (
        {
            SAYS: SAYS + "        while True:\n            time.sleep(1)\n",
            "import rclpy\n": "import time\n\nimport rclpy\n",
        },
        "The heartbeat: counter 2, due",
        "keeps its callback from returning",
    ),
    ({CANCELS: "        self.executor.shutdown()\n"}, "The heartbeat: counter 2, due", "Stop one timer"),
    (
        {"self.timer = ": "timer = "},
        "AttributeError: 'SpinnerPyNode' object has no attribute 'timer'",
        "`timer` is a variable of one function.",
    ),
    (
        {KEEPS: KEEPS.replace(")", ", oneshot=True)")},
        "unexpected keyword argument 'oneshot'",
        "In ROS 2 a timer has no `oneshot`.",
    ),
    ({CANCELS: "        self.timer.shutdown()\n"}, "has no attribute 'shutdown'", "A `Timer` has no `shutdown`."),
    ({"timer_callback(self)": "timer_callback(self, event)"}, "missing 1 required positional", "no argument"),
    ({KEEPS: KEEPS.replace("timer_callback)", "timer_callback())")}, "has no attribute 'timer'", "Python names"),
    ({SPIN: "        pass\n"}, "no counter was printed", "Does its main part come to `rclpy.spin(node)`?"),
    ({"    rclpy.init()\n": ""}, "NotInitialized", "Call rclpy.init() before"),
    (
        {
            CANCELS: "        threading.Timer(1.0, self.timer.cancel).start()\n        if self.counter: return\n",
            KEEPS: "self.timer = self.create_timer(0.5, self.timer_callback)",
            "import rclpy\n": "import threading\n\nimport rclpy\n",
        },
        "counter 1 came at 0.5 s, not at 1.5 s",
        "Stop the timer itself",
    ),
]
