"""A subscription always gets the newest message: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Listen to the newest only"
TEXT = """
**You need**: [how much a subscription keeps](ros2-publish.md) and [executors](ros2-executors.md).

The sensor of this node publishes a position every 0.1 s. The controller computes for 0.33 s with each position that it
takes, and soon steers by positions that are almost a second old. Change how the controller listens, so that it always
takes the newest position. The computation still takes 0.33 s, and the sensor stays as it is.

(The callbacks do not wait for each other: the executor has several threads, and the sensor's timer a group of its own.)
"""
REVEALS = "A subscription always gets the newest message. It is the publisher's queue that has to be short."

NODE = """
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import UInt32


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.position = 0
        self.publisher = self.create_publisher(UInt32, "position", 10)
        self.create_timer(0.1, self.sensor_callback, MutuallyExclusiveCallbackGroup())
        self.create_subscription(UInt32, "position", self.position_callback, 10)

    def sensor_callback(self):
        self.position += 1
        self.publisher.publish(UInt32(data=self.position))

    def position_callback(self, message):
        self.get_logger().info("[CONTROLLER] position = " + str(message.data))
        time.sleep(0.33)


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node, MultiThreadedExecutor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

HINTS = [
    "Where are the published positions while the controller computes?",
    "In the queue of the subscription. Its last argument, `10`, says how many may wait there. Which one is taken next?",
    "The oldest is taken next. In a queue for one message, the newest takes the place of the one before.",
]
_QUEUE = "The last argument of `create_subscription` says how many messages may wait there."
HINT = _QUEUE

check = by.run(10.0, by.steers_by_the_newest("reliable, volatile, depth 10"))

SOLUTION = {"self.position_callback, 10)": "self.position_callback, 1)"}

TAKES_ONE = "self.position_callback, 1)"
QUEUE = "how many messages may wait there"
STAYS = "The sensor should stay as it is"

RIGHT = [
    {TAKES_ONE: "self.position_callback, qos_profile=1)"},
    {
        TAKES_ONE: "self.position_callback, QoSProfile(depth=1))",
        "from std_msgs": "from rclpy.qos import QoSProfile\nfrom std_msgs",
    },
    {
        TAKES_ONE: "self.position_callback, 1, callback_group=MutuallyExclusiveCallbackGroup())",
        "0.1, self.sensor_callback, MutuallyExclusiveCallbackGroup()": "0.1, self.sensor_callback",
    },
    {"time.sleep(0.33)": "time.sleep(0.35)"},
    {
        TAKES_ONE: "self.store, 10)\n        self.newest = None\n"
        "        self.create_timer(0.01, self.step, MutuallyExclusiveCallbackGroup())",
        "    def position_callback(self, message):\n": "    def store(self, message):\n"
        "        self.newest = message.data\n\n    def step(self):\n        if self.newest is None:\n"
        "            return\n",
        "str(message.data)": "str(self.newest)",
    },
]
WRONG = [
    (
        {TAKES_ONE: "self.position_callback, 10)", "str(message.data)": "str(self.position)"},
        "printed position 4, but the message that it got held 2",
        "in another process",
    ),
    (
        {'"position", 10)\n': '"position", 1)\n'},
        "the sensor: its publisher now has reliable, volatile, depth 1, where it had reliable, volatile, depth 10",
        STAYS,
    ),
    (
        {
            f'self.create_subscription(UInt32, "position", {TAKES_ONE}\n': "self.newest = UInt32(data=1)\n"
            "        self.create_timer(0.34, lambda: self.position_callback(self.newest), "
            "MutuallyExclusiveCallbackGroup())\n",
            "        self.publisher.publish(": "        self.newest = UInt32(data=self.position)\n"
            "        self.publisher.publish(",
        },
        "the controller: nothing subscribes to `/position`",
        "letter by letter",
    ),
    (
        {TAKES_ONE: "self.position_callback, 10)"},
        "the controller steered by position 2, which was 0.23 s old",
        QUEUE,
    ),
    ({TAKES_ONE: "self.position_callback, 2)"}, "A newer one had arrived", QUEUE),
    (
        {TAKES_ONE: "self.position_callback, 10)", '"position", 10)\n': '"position", 1)\n'},
        "A newer one had arrived",
        QUEUE,
    ),
    ({"time.sleep(0.33)": "time.sleep(0.05)"}, "less than 0.33 s after the last time", "takes 0.33 s"),
    (
        {"(0.1, self.sensor": "(0.4, self.sensor"},
        "the sensor published 25 positions",
        "The sensor should stay as it is.",
    ),
    ({", MultiThreadedExecutor())": ")"}, "the sensor published", "The sensor should stay as it is."),
    ({"str(message.data)": "str(message)"}, "is not a position that", "A message is not yet its number:"),
    (
        {"time.sleep(0.33)": "time.sleep(0.6)"},
        "the controller steered 17 times",
        "From one step to the next it took up to 0.6 s.",
    ),
    (
        {"        self.create_subscription": "        pass  # "},
        "the controller: nothing subscribes to `/position`.",
        "The subscription uses the publisher's topic, letter by letter",
    ),
    (
        {TAKES_ONE: "self.position_callback(), 1)"},
        "missing 1 required positional",
        "Pass the function on without calling it:",
    ),
]
