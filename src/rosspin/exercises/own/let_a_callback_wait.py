"""More threads are enough to let a callback wait: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Let a callback wait"
TEXT = """
**You need**: [which executor and which groups](ros2-executors.md) there are, and the how-to
[Why does my node hang?](../docs/how-to/why-does-it-hang.rst)

This robot should ask its left eye, then its right eye, which take 0.1 s each, and then print a line. It hangs at the
left one. Repair it without changing `timer_callback`: change what is around it.
"""
REVEALS = "More threads are enough to let a callback wait. A callback group of its own is enough."

NODE = """
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_srvs.srv import Trigger


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.counter = 0
        self.create_service(Trigger, "left_eye", self.eye_callback)
        self.create_service(Trigger, "right_eye", self.eye_callback)
        self.left = self.create_client(Trigger, "left_eye")
        self.right = self.create_client(Trigger, "right_eye")
        self.create_timer(1.0, self.timer_callback)

    def eye_callback(self, request, response):
        time.sleep(0.1)
        return response

    def timer_callback(self):
        self.left.call(Trigger.Request())
        self.right.call(Trigger.Request())
        self.counter += 1
        self.get_logger().info("[ROBOT] counter = " + str(self.counter))


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

HINTS = [
    "While `timer_callback` waits, the service has to be called, and the client has to take the "
    "answer. Which thread can do that?",
    "With more threads, `rclpy.spin(robot_py_node, MultiThreadedExecutor())`, it still hangs. What does the "
    "line that begins with `rosspin: the request has come` name now?",
    "All callbacks of the node are in its default group, in which one runs at a time. Take the "
    "waiting one out of it: `self.create_timer(1.0, self.timer_callback, "
    "MutuallyExclusiveCallbackGroup())`.",
]
_RING = (
    "While a callback waits, it keeps its thread and its callback group. If the node hangs, the lines that begin with "
    "`rosspin:` say who waits, for what, and who would give that."
)
_EYES = "The eyes and `timer_callback` should stay as they are: each eye takes 0.1 s, the left one first, every second."
HINT = "It takes two things: a `MultiThreadedExecutor`, and a callback group of its own for the callback that waits."

check = by.goes_on(
    3.6,
    by.answered("/left_eye", 0.1, at=[1.0, 2.0, 3.0], hint=_RING, overlap=_EYES),
    by.answered("/right_eye", 0.1, at=[1.1, 2.1, 3.1], hint=_RING, overlap=_EYES),
    by.ticks(1.0, "The robot", "ROBOT", _RING, start=1.2),
    hint=_RING,
)

SOLUTION = {
    "from rclpy.executors import ExternalShutdownException\n": "from rclpy.callback_groups import "
    "MutuallyExclusiveCallbackGroup\n"
    "from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor\n",
    "self.timer_callback": "self.timer_callback, MutuallyExclusiveCallbackGroup()",
    "        rclpy.spin(robot_py_node)\n": "        rclpy.spin(robot_py_node, MultiThreadedExecutor())\n",
}
AFTER = """
One problem remains: if Ctrl-C comes while a thread waits in `call`, nothing wakes that thread, and the node does not
end.
"""

MUTUAL_TIMER = "MutuallyExclusiveCallbackGroup()"
MUTUAL_IMPORT = "import MutuallyExclusiveCallbackGroup"
EYES = """    def timer_callback(self):
        self.left.call(Trigger.Request())
        self.right.call(Trigger.Request())
"""

RIGHT = [
    {"MultiThreadedExecutor()": "MultiThreadedExecutor(2)"},
    {MUTUAL_TIMER: "ReentrantCallbackGroup()", MUTUAL_IMPORT: "import ReentrantCallbackGroup"},
    # Each end in a group of its own.
    {
        f", {MUTUAL_TIMER}": "",
        "self.eye_callback)": f"self.eye_callback, callback_group={MUTUAL_TIMER})",
        '"left_eye")': f'"left_eye", callback_group={MUTUAL_TIMER})',
        '"right_eye")': f'"right_eye", callback_group={MUTUAL_TIMER})',
    },
    # Without a second thread.
    {
        "def timer_callback": "async def timer_callback",
        "self.left.call(": "await self.left.call_async(",
        "self.right.call(": "await self.right.call_async(",
        ", MultiThreadedExecutor())": ")",
    },
    {
        EYES: """    def timer_callback(self):
        self.left.call_async(Trigger.Request()).add_done_callback(self.has_left)

    def has_left(self, future):
        self.right.call_async(Trigger.Request()).add_done_callback(self.has_both)

    def has_both(self, future):
""",
        f", {MUTUAL_TIMER}": "",
        ", MultiThreadedExecutor())": ")",
    },
]
WRONG = [
    ({f", {MUTUAL_TIMER}": ""}, "the request of 1 s to `/left_eye` was not answered", "say who waits"),
    ({", MultiThreadedExecutor())": ")"}, "`/left_eye` was not answered", "keeps its thread"),
    ({"MultiThreadedExecutor()": "MultiThreadedExecutor(1)"}, "`/left_eye` was not answered", "say who waits"),
    # The answers come, but the clients are in the group of the callback that waits.
    (
        {
            f", {MUTUAL_TIMER}": "",
            "self.eye_callback)": f"self.eye_callback, callback_group={MUTUAL_TIMER})",
        },
        "The robot: no counter was printed",
        "say who waits",
    ),
    (
        {
            f", {MUTUAL_TIMER}": "",
            '"left_eye")': f'"left_eye", callback_group={MUTUAL_TIMER})',
            '"right_eye")': f'"right_eye", callback_group={MUTUAL_TIMER})',
        },
        "`/left_eye` was not answered",
        "say who waits",
    ),
    # One group for all of them is the default group again.
    (
        {
            "        self.counter = 0\n": f"        self.counter = 0\n        group = {MUTUAL_TIMER}\n",
            f"self.timer_callback, {MUTUAL_TIMER}": "self.timer_callback, group",
            "self.eye_callback)": "self.eye_callback, callback_group=group)",
        },
        "`/left_eye` was not answered",
        "say who waits",
    ),
    (
        {"Trigger.Request())\n": "Trigger.Request(), timeout_sec=0.05)\n", f", {MUTUAL_TIMER}": ""},
        "to `/left_eye` was answered at 1.2 s, not at 1.1 s",
        "",
    ),
    (
        {"self.left.call(": "self.left.call_async(", "self.right.call(": "self.right.call_async("},
        "`/right_eye` was asked at 1 s, not at 1.1 s",
        "",
    ),
    (
        {"        self.right.call(Trigger.Request())\n": ""},
        "`/right_eye` was never asked",
        "come from the service",
    ),
    ({"time.sleep(0.1)": "pass"}, "was answered at 1 s, not at 1.1 s", "each eye takes 0.1 s"),
]
