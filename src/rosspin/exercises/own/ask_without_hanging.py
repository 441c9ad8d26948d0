"""A callback may wait for an answer: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Ask without hanging"
TEXT = """
**You need**: [services and actions](ros2-services.md) and the how-to
[Why does my node hang?](../docs/how-to/why-does-it-hang.rst)

This robot hangs as soon as it has asked for a picture. Fix it: it should ask every second, print each picture as soon
as it arrives, and keep its heartbeat.
"""
REVEALS = "A callback may wait for an answer. `call_async` returns the answer."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_srvs.srv import Trigger


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.pictures = 0
        self.beats = 0
        self.create_service(Trigger, "take_picture", self.picture_callback)
        self.client = self.create_client(Trigger, "take_picture")
        self.create_timer(1.0, self.timer_callback)
        self.create_timer(0.5, self.heartbeat_callback)

    def picture_callback(self, request, response):
        self.pictures += 1
        response.message = "[CAMERA] counter = " + str(self.pictures)
        return response

    def timer_callback(self):
        response = self.client.call(Trigger.Request())
        self.get_logger().info(response.message)

    def heartbeat_callback(self):
        self.beats += 1
        self.get_logger().info("[HEARTBEAT] counter = " + str(self.beats))


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
    "Read the lines that begin with `rosspin:`. What waits, and for which callback?",
    "`self.client.call_async(...)` sends the request and returns immediately. It returns a future, not the answer.",
    "Use the answer in a method `done_callback(self, future)`, which you give to the future: "
    "`future.add_done_callback(self.done_callback)`. The answer is `future.result()`.",
]
_RING = (
    "While a callback waits, it keeps its thread and its callback group. If the node hangs, the lines that begin with "
    "`rosspin:` say who waits, for what, and who would give that."
)
_PRINT = "Print the `message` of each answer as soon as it has come: in a function that you give to the future."
HINT = "Ask with `call_async`. Print in a function that you give to the future's `add_done_callback`."

check = by.goes_on(
    4.3,
    by.answered("/take_picture", at=[1.0, 2.0, 3.0, 4.0], hint=_RING),
    by.ticks(1.0, "The pictures", "CAMERA", _PRINT),
    by.ticks(0.5, "The heartbeat", "HEARTBEAT", _RING),
    hint=_RING,
)

SOLUTION = {
    "        response = self.client.call(Trigger.Request())\n"
    "        self.get_logger().info(response.message)\n": "        future = "
    "self.client.call_async(Trigger.Request())\n"
    "        future.add_done_callback(self.done_callback)\n"
    "\n"
    "    def done_callback(self, future):\n"
    "        self.get_logger().info(future.result().message)\n",
}
AFTER = """
With `await` instead, the timer needs a callback group of its own; with `call`, a second thread as well: see the next
exercise.
"""

ASKS_EACH_SECOND = "self.create_timer(1.0, self.timer_callback)"
MUTUAL_TIMER = "MutuallyExclusiveCallbackGroup()"
IN_A_GROUP = f"self.create_timer(1.0, self.timer_callback, groups.{MUTUAL_TIMER})"
REENTRANT = "self.create_timer(1.0, self.timer_callback, groups.ReentrantCallbackGroup())"
GROUPS = {"import rclpy\n": "import rclpy\nfrom rclpy import callback_groups as groups\n"}
IN_THREADS = {
    "rclpy.spin(robot_py_node)": "rclpy.spin(robot_py_node, MultiThreadedExecutor())",
    "import ExternalShutdownException\n": "import ExternalShutdownException, MultiThreadedExecutor\n",
}
DONE = """        future = self.client.call_async(Trigger.Request())
        future.add_done_callback(self.done_callback)

    def done_callback(self, future):
        self.get_logger().info(future.result().message)
"""
DONE_AT_ONCE = """        future = self.client.call_async(Trigger.Request())
        self.get_logger().info(future.result().message)
"""
CALLS = """        response = self.client.call(Trigger.Request())
        self.get_logger().info(response.message)
"""
AWAITS = CALLS.replace("self.client.call(", "await self.client.call_async(")
CALLS_IN_A_THREAD = f"""        threading.Thread(target=self.ask, daemon=True).start()

    def ask(self):
{CALLS}"""
POLLS = DONE_AT_ONCE.replace(
    "        self.get", "        while not future.done():\n            time.sleep(0.1)\n        self.get"
)
SPINS_IN_IT = DONE_AT_ONCE.replace(
    "        self.get", "        rclpy.spin_until_future_complete(self, future)\n        self.get"
)

RIGHT = [
    {
        ".add_done_callback(self.done_callback)": ".add_done_callback(\n"
        "            lambda done: self.get_logger().info(done.result().message))"
    },
    # It waits without keeping the thread, or with another one.
    {DONE: AWAITS, "def timer_callback": "async def timer_callback", ASKS_EACH_SECOND: IN_A_GROUP, **GROUPS},
    {DONE: CALLS, ASKS_EACH_SECOND: IN_A_GROUP, **GROUPS, **IN_THREADS},
    {DONE: CALLS, ASKS_EACH_SECOND: REENTRANT, **GROUPS, **IN_THREADS},
    {DONE: CALLS_IN_A_THREAD, "import rclpy\n": "import threading\nimport rclpy\n"},
]
WRONG = [
    # The answer is used immediately.
    (
        {DONE: DONE_AT_ONCE},
        "the node stopped in line 24: `AttributeError: 'NoneType' object has no attribute 'message'`",
        "The result of a future is None until the answer has come",
    ),
    ({DONE: POLLS, "import rclpy\n": "import time\nimport rclpy\n"}, "was not answered", "say who waits"),
    (
        {DONE: SPINS_IN_IT},
        "was not answered",
        "say who waits",
    ),
    # A coroutine keeps the group of the service.
    (
        {DONE: AWAITS, "def timer_callback": "async def timer_callback"},
        "The request of 1 s to `/take_picture` was not answered",
        "keeps its thread and its callback group",
    ),
    ({DONE: CALLS, ASKS_EACH_SECOND: IN_A_GROUP, **GROUPS}, "was not answered", "say who waits"),
    ({DONE: CALLS, **IN_THREADS}, "did not end at Ctrl-C", "say who waits"),
    (
        {DONE: CALLS.replace("Request()", "Request(), timeout_sec=0.2")},
        "`AttributeError: 'NoneType' object",
        "until the answer has come",
    ),
    ({"(self.done_callback)": "(self.done_callback(future))"}, "stopped in line 27", "until the answer has come"),
    (
        {
            "        future = self.client.call_async(Trigger.Request())\n": "",
            "        future.add_done_callback(self.done_callback)\n": "        self.done_callback(None)\n",
            "future.result().message": '"[CAMERA] counter = 1"',
        },
        "`/take_picture` was never asked",
        "come from the service",
    ),
    ({"1.0, self.timer": "0.5, self.timer"}, "was asked at 0.5 s, not at 1 s", "is not to change"),
    ({"        self.create_timer(0.5, self.heartbeat_callback)\n": ""}, "heartbeat: no counter", ""),
]
