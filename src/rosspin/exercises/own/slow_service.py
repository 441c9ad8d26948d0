"""A service runs at the same time as other callbacks of its node: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Keep a timer on time"
TEXT = """
**You need**: [services and actions](ros2-services.md), and
[which executor and which groups](ros2-executors.md) there are.

The motor of this robot needs a command every 0.1 s. But the robot also offers a service that takes a picture, which
needs 0.35 s, or in the dark 1.3 s. Change the node so that

- the motor gets each command on time, however long a picture takes, and
- each request is answered, one picture after the other.
"""
REVEALS = "A service runs at the same time as other callbacks of its node. Only the client waits for a slow service."

NODE = """
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_srvs.srv import Trigger


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.takes = self.declare_parameter("takes", 0.35).value
        self.commands = 0
        self.create_service(Trigger, "take_picture", self.picture_callback)
        self.client = self.create_client(Trigger, "take_picture")
        self.create_timer(1.0, self.ask_callback)
        self.create_timer(0.1, self.motor_callback)

    def picture_callback(self, request, response):
        time.sleep(self.takes)
        response.message = "a picture"
        return response

    def ask_callback(self):
        future = self.client.call_async(Trigger.Request())
        future.add_done_callback(self.done_callback)

    def done_callback(self, future):
        self.get_logger().info("[ROBOT] has " + future.result().message)

    def motor_callback(self):
        self.commands += 1
        self.get_logger().info("[MOTOR] counter = " + str(self.commands))


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
    "The client asks with `call_async`, so the client does not keep the motor waiting. What does?",
    "`picture_callback` and `motor_callback` have to run at the same time. That takes a second "
    "thread, and two callback groups.",
    "`create_service` takes a `callback_group`. In a `MutuallyExclusiveCallbackGroup` of its own, "
    "the service takes one picture at a time; in a `ReentrantCallbackGroup` it would begin a second "
    "one.",
]
_RING = (
    "The lines that begin with `rosspin:` say who waits, for what, and who would give that. While a callback waits, it "
    "keeps its thread and its callback group."
)
_SERVING = (
    "While the camera takes a picture, a single-threaded executor calls nothing, and no executor calls what is in the "
    "same mutually exclusive group. All callbacks of a node are in one such group unless you give them others."
)
_ONE_BY_ONE = "A camera takes one picture at a time, and takes its time for it. Calls of one group do not overlap."
HINT = (
    "It takes two things: a `MultiThreadedExecutor`, and a callback group in which the service does not keep "
    "the motor waiting."
)

check = by.until_wrong(
    *(
        by.goes_on(
            5.05,
            by.ticks(0.1, "the motor", "MOTOR", by.unless_regular(0.1, _SERVING)),
            by.answered(
                "/take_picture",
                takes,
                least=least,
                hint="Each request should be answered, in its turn.",
                overlap=_ONE_BY_ONE,
            ),
            given=f"takes:={takes}",
            hint=_RING,
        )
        for takes, least in ((0.35, 5), (1.3, 4))
    )
)

SOLUTION = {
    "from rclpy.executors import ExternalShutdownException\n": "from rclpy.callback_groups import "
    "MutuallyExclusiveCallbackGroup\n"
    "from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor\n",
    '        self.create_service(Trigger, "take_picture", self.picture_callback)\n': "        self.create_service(\n"
    '            Trigger, "take_picture", self.picture_callback,\n'
    "            callback_group=MutuallyExclusiveCallbackGroup())\n",
    "        rclpy.spin(robot_py_node)\n": "        rclpy.spin(robot_py_node, MultiThreadedExecutor())\n",
}
AFTER = """
With pictures of 1.3 s, requests come faster than they can be answered, and wait in a queue. By default a service
keeps the newest 10, so in a long run the oldest are dropped.
"""

MUTUAL_TIMER = "MutuallyExclusiveCallbackGroup()"
MUTUAL_IMPORT = "import MutuallyExclusiveCallbackGroup"
SLOW_GROUP = f",\n            callback_group={MUTUAL_TIMER})"
SLOW_SERVICE = f"""self.create_service(
            Trigger, "take_picture", self.picture_callback{SLOW_GROUP}"""
SPIN_SLOW = "        rclpy.spin(robot_py_node, MultiThreadedExecutor())\n"

RIGHT = [
    {"MultiThreadedExecutor()": "MultiThreadedExecutor(2)"},
    {SLOW_GROUP: ")", "self.motor_callback)": f"self.motor_callback, {MUTUAL_TIMER})"},
    {
        SLOW_GROUP: ")",
        "self.motor_callback)": "self.motor_callback, ReentrantCallbackGroup())",
        MUTUAL_IMPORT: "import ReentrantCallbackGroup",
    },
    {
        SPIN_SLOW: "        executor = MultiThreadedExecutor(num_threads=3)\n"
        "        executor.add_node(robot_py_node)\n        executor.spin()\n"
    },
    # The camera is a node with an executor and a thread of its own.
    {
        SLOW_SERVICE: 'self.camera = rclpy.create_node("camera")\n'
        '        self.camera.create_service(Trigger, "take_picture", self.picture_callback)',
        SPIN_SLOW: "        executor = SingleThreadedExecutor()\n"
        "        executor.add_node(robot_py_node.camera)\n"
        "        threading.Thread(target=executor.spin, daemon=True).start()\n"
        "        rclpy.spin(robot_py_node)\n",
        "import time\n": "import threading\nimport time\n",
        "MultiThreadedExecutor\n": "SingleThreadedExecutor\n",
    },
]
WRONG = [
    ({SLOW_GROUP: ")"}, "With `takes:=0.35`, the motor: counter 11 came at 1.35 s", "unless you give them others"),
    ({", MultiThreadedExecutor())": ")"}, "counter 11 came at 1.35 s", "a single-threaded executor calls nothing"),
    ({"MultiThreadedExecutor()": "MultiThreadedExecutor(1)"}, "counter 11 came at 1.35 s", "calls nothing"),
    (
        {
            "        future = self.client.call_async(Trigger.Request())\n"
            "        future.add_done_callback(self.done_callback)\n": "        self.client.call(Trigger.Request())\n"
        },
        "With `takes:=0.35`, the motor: counter 10, due at 1 s, did not come",
        "unless you give them others",
    ),
    (
        {MUTUAL_TIMER: "ReentrantCallbackGroup()", MUTUAL_IMPORT: "import ReentrantCallbackGroup"},
        "With `takes:=1.3`: the request of 2 s to `/take_picture` was answered at 3.3 s, not at 3.6 s",
        "one picture at a time",
    ),
    (
        {
            SLOW_GROUP: ",\n            callback_group=group)",
            "        self.commands = 0\n": f"        self.commands = 0\n        group = {MUTUAL_TIMER}\n",
            "self.motor_callback)": "self.motor_callback, group)",
        },
        "counter 11 came at 1.35 s",
        "in the same mutually exclusive group",
    ),
    ({"        time.sleep(self.takes)\n": ""}, "was answered at 1 s, not at 1.35 s", "takes its time for it"),
    ({"time.sleep(self.takes)": "time.sleep(0.35)"}, "was answered at 1.35 s, not at 2.3 s", "takes its time"),
    ({"        self.create_timer(1.0, self.ask_callback)\n": ""}, "was never asked", "from the service"),
    (
        {"1.0, self.ask": "2.0, self.ask"},
        "`/take_picture` was asked 2 times in 5.05 s, not 5 times",
        "not to change",
    ),
    (
        {"def picture_callback": "async def picture_callback", SLOW_GROUP: ")", ", MultiThreadedExecutor())": ")"},
        "counter 11 came at 1.35 s",
        "a single-threaded executor",
    ),
]
