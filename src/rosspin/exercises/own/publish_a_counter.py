"""A number is a message: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Publish a counter"
TEXT = """
**You need**: [publish and subscribe in ROS 2](../docs/ros2/publish.rst) and [its notebook](ros2-publish.md).

This node listens for `std_msgs/msg/UInt32` messages on the topic `counter`. Make its timer publish 1, 2, 3 and so on
there, five times a second, beginning one period after the start. A subscriber in another process should hear the first
message, too. Do not change the subscription.
"""
REVEALS = "A number is a message. A publisher can be made when it is needed."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.counter = 0
        self.create_subscription(UInt32, "counter", self.counter_callback, 10)
        self.create_timer(0.5, self.timer_callback)

    def timer_callback(self):
        self.counter += 1

    def counter_callback(self, message):
        self.get_logger().info("[LISTENER] counter = " + str(message.data))


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
    "Two things are missing: the publisher, and a line in the timer's callback that uses it. Where does each belong?",
    "`self.create_publisher` takes the type of the messages, the name of the topic, and how many "
    "messages may wait: 10.",
    "A number is not a message: `UInt32(data=self.counter)` is. And a new publisher is not "
    "connected to another process yet.",
]
HINT = 'Make a `self.create_publisher(UInt32, "counter", 10)` in `__init__`, and publish in the callback.'

check = by.published_and_heard

SOLUTION = {
    "        self.counter = 0\n": "        self.counter = 0\n"
    '        self.publisher = self.create_publisher(UInt32, "counter", 10)\n',
    "0.5": "0.2",
    "        self.counter += 1\n": "        self.counter += 1\n"
    "        self.publisher.publish(UInt32(data=self.counter))\n",
}

SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"
MAKES_PUBLISHER = '        self.publisher = self.create_publisher(UInt32, "counter", 10)\n'
PUBLISHES = "        self.publisher.publish(UInt32(data=self.counter))\n"
IN_EACH_CALL = {  # a publisher is made for each message
    MAKES_PUBLISHER: "",
    PUBLISHES: f"{MAKES_PUBLISHER}{PUBLISHES}",
}
MADE_ONCE = "Make it once, before the timer"

RIGHT = [
    {
        PUBLISHES: "        message = UInt32()\n        message.data = self.counter\n"
        "        self.publisher.publish(message)\n"
    },
    {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('"counter"', '"/counter"')},
    {MAKES_PUBLISHER: MAKES_PUBLISHER.replace(", 10)", ", 1)")},
    {"self.create_timer(0.2,": "self.create_timer(1 / 5,"},
    {TRY.replace("spinner", "robot"): "    rclpy.spin(robot_py_node)\n"},
]
WRONG = [
    (
        {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('UInt32, "counter"', '"counter", UInt32')},
        "TypeError",
        "the type, the",
    ),
    ({PUBLISHES: PUBLISHES.replace("UInt32(data=self.counter)", "UInt32")}, "TypeError", "make one, with `()`"),
    ({"data=self.counter": "self.counter"}, "takes 1 positional argument", "given by their names"),
    ({"data=self.counter": "data=str(self.counter)"}, "must be of type 'int'", "values of its own type"),
    ({PUBLISHES: PUBLISHES.replace(".publish(", "(")}, "not callable", "Call what it has, such as `publish`"),
    (IN_EACH_CALL, "the node made 10 publishers of `/counter`, where one would do", MADE_ONCE),
    (
        {
            MAKES_PUBLISHER: "        self.publisher = None\n",
            PUBLISHES: "        if self.publisher is None:\n    " + MAKES_PUBLISHER + PUBLISHES,
        },
        "the publisher was made at 0.2 s, when its first message was already due",
        MADE_ONCE,
    ),
    (
        {
            MAKES_PUBLISHER: "",
            PUBLISHES: f"{MAKES_PUBLISHER}{PUBLISHES}        self.destroy_publisher(self.publisher)\n",
        },
        "the node made 10 publishers",
        MADE_ONCE,
    ),
    (
        {
            "        self.create_subscription(": "        pass  # ",
            PUBLISHES: f"{PUBLISHES}        self.counter_callback(UInt32(data=self.counter))\n",
        },
        "The listener: its lines were printed in a call of a timer",
        "A topic carries the message",
    ),
    (
        {PUBLISHES: ""},
        "on `/counter`: the node published nothing",
        "There is a publisher, but nothing publishes with it.",
    ),
    (
        {
            MAKES_PUBLISHER: MAKES_PUBLISHER.replace("10)", "qos_profile_sensor_data)"),
            "import rclpy\n": "import rclpy\nfrom rclpy.qos import qos_profile_sensor_data\n",
        },
        "The listener: no counter was printed",
        "The publisher offers less than the listener asks for",
    ),
    (
        {"[LISTENER] counter": "[LISTENER] number"},
        "The listener: no counter was printed",
        "Leave the listener as it is",
    ),
    ({MAKES_PUBLISHER: ""}, "has no attribute 'publisher'", "with its `self.`"),
    (
        {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('"counter"', '"count"')},
        "it was published on `/count`",
        "The publisher uses the listener's topic, letter by letter:",
    ),
    (
        {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('"counter"', '"~/counter"')},
        "it was published on `/robot_py_node/counter`",
        "The publisher uses the listener's topic, letter by letter:",
    ),
    ({"(0.2,": "(5,"}, "nothing was published on `/counter`", "Five times a second is once in 1 / 5 s."),
    (
        {"(0.2,": "(0.5,"},
        "On `/counter`: counter 1 came at 0.5 s, not at 0.2 s",
        "Five times a second is once in 1 / 5 s.",
    ),
    ({"UInt32(data=self.counter)": "self.counter"}, "TypeError", "A number is not yet a message:"),
    (
        {"UInt32(data=self.counter)": "UInt32()"},
        "on `/counter`: each message holds 0, not a counter.",
        "A new message holds 0.",
    ),
    (
        {"        self.counter += 1\n" + PUBLISHES: PUBLISHES + "        self.counter += 1\n"},
        "where counter 1 was due, counter 0 came",
        "The first counter is 1:",
    ),
    (
        {PUBLISHES: PUBLISHES * 2},
        "On `/counter`: where counter 2 was due, counter 1 came",
        "A counter comes more than once:",
    ),
    (
        {MAKES_PUBLISHER: MAKES_PUBLISHER.replace(", 10)", ")")},
        "missing 1 required positional",
        '`self.create_publisher(UInt32, "topic", 10)`:',
    ),
    (
        {"        self.create_subscription": "        pass  # "},
        "The listener: no counter",
        "Nothing subscribes to `/counter` any more.",
    ),
]
