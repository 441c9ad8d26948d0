"""Whoever sent last steers. A node that shares a topic has to find out who else publishes on it."""

from __future__ import annotations

from collections.abc import Iterator

from .. import Finding
from ..driving import commands, driver_cpp, follows, stands
from ..judging import Answer, plain, say
from ..observed import ObservedRun

TITLE = "Share the wheel"
TEXT = """
From 3 s to 5 s a joystick, which is another node, should stop the vehicle: it publishes a speed of 0 on `/cmd_vel`,
four times a second. Your node sends more often, and wins. Find out which other node publishes there, print its name as
`[DRIVER] other = ` and the name, and send nothing meanwhile. Then drive on.
"""
REVEALS = "A topic has one publisher. The first one, or the one that matters, wins."

NODE = """
import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32


class DriverPyNode(Node):
    def __init__(self):
        super().__init__("driver_py_node")
        self.offset = 0.0
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(Float32, "line", self.line_callback, 10)
        self.create_timer(0.05, self.timer_callback)

    def line_callback(self, message):
        self.offset = message.data

    def timer_callback(self):
        command = Twist()
        command.linear.x = 2.0
        command.angular.z = 8.0 * self.offset
        self.publisher.publish(command)


def main():
    rclpy.init()
    driver_py_node = DriverPyNode()
    try:
        rclpy.spin(driver_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

NODE_CPP = driver_cpp("50ms")

HINTS = [
    "Which of two commands does the vehicle follow, and which node sends more of them?",
    "`self.count_publishers('cmd_vel')` says how many publish there, your node included.",
    "`self.get_publishers_info_by_topic('cmd_vel')` says who: each has a `node_name`.",
]
HINTS_CPP = [
    "Which of two commands does the vehicle follow, and which node sends more of them?",
    '`count_publishers("cmd_vel")` says how many publish there, your node included.',
    '`get_publishers_info_by_topic("cmd_vel")` says who: each has a `node_name()`.',
]

_YIELD = (
    "The wheels keep what came last, whoever sent it, and your node sends more. While another node publishes on "
    "`cmd_vel`, send nothing."
)


def check(answer: Answer) -> Iterator[Finding]:
    """Whether the joystick stops the vehicle while it is pressed, and the node says who that was, whoever it is."""
    findings = list(_yields(answer.run(8.0, beside=["vehicle", "joystick"]), "joystick", 3.0, 5.0))
    yield from findings
    if all(finding.right for finding in findings):
        for finding in _yields(answer.run(5.0, beside=["vehicle", "tablet"]), "tablet", 2.0, 3.5):
            if not finding.right:
                yield finding._replace(
                    text=f"A node `tablet` in place of the joystick, from 2 s to 3.5 s: {finding.text}"
                )


def _yields(run: ObservedRun, name: str, pressed: float, released: float) -> Iterator[Finding]:
    """Whether another node of this name stops the vehicle while it is pressed, and the node says who that was."""
    before = follows(run, "Steer as before while no other node does.", 0.0, pressed)
    yield before
    if not before.right:
        return
    yield stands(run, pressed + 0.6, released, _YIELD)
    ours = [command.time for command in commands(run, pressed + 0.3, released - 0.01)]
    if ours:
        yield Finding(False, f"at {say(ours[-1])}, with the joystick pressed, the node still sent commands.", _YIELD)
        return
    if not [command for command in commands(run, released + 0.01, released + 1.0) if command.speed]:
        hint = "Look at each tick who publishes, and steer as soon as no other node does."
        yield Finding(False, f"the joystick was gone at {say(released)}, but the node did not drive again.", hint)
        return
    yield Finding(True, "while the joystick is pressed the node sends nothing, and then drives again.")
    named = [line for line in run.values("DRIVER", "other") if pressed <= line.time <= released]
    names = {line.text.strip("/'\"[] ") for line in named}
    if names != {name}:
        said = " and ".join(f"`{plain(each)}`" for each in sorted(names)) or "nothing"
        hint = "Print `[DRIVER] other = ` and the `node_name` of the publisher that is not yours."
        yield Finding(False, f"asked who else publishes on `cmd_vel`, the node printed {said}.", hint)


_SENDS = "    def timer_callback(self):\n"
_NOW = "self.get_clock().now().nanoseconds / 1e9"
_OTHERS = "[each.node_name for each in self.get_publishers_info_by_topic('cmd_vel')]"
RIGHT = [
    {
        _SENDS: f"{_SENDS}        names = {_OTHERS}\n"
        "        for name in names:\n            if name != self.get_name():\n"
        "                self.get_logger().info('[DRIVER] other = ' + name)\n                return\n",
    },
    {
        _SENDS: f"{_SENDS}        if self.count_publishers('cmd_vel') > 1:\n"
        f"            other, = set({_OTHERS}) - {{'driver_py_node'}}\n            print('[DRIVER] other =', other)\n"
        "            return\n",
    },
    {
        "self.offset = 0.0\n": "self.offset = 0.0\n        self.told = ''\n",
        _SENDS: f"{_SENDS}        others = sorted(set({_OTHERS}) - {{self.get_name()}})\n"
        "        if others and self.told != others:\n"
        "            self.get_logger().warn(f'[DRIVER] other = /{others[0]}')\n"
        "        self.told = others\n        if others:\n            return\n",
    },
    {  # its own timer looks
        "        self.create_timer(0.05": "        self.other = None\n        self.create_timer(0.02, self.look)\n"
        "        self.create_timer(0.05",
        _SENDS: f"    def look(self):\n        found = [name for name in {_OTHERS} if name != 'driver_py_node']\n"
        "        if found and not self.other:\n            self.get_logger().info('[DRIVER] other = ' + found[0])\n"
        f"        self.other = found\n\n{_SENDS}        if self.other:\n            return\n",
    },
]
WRONG = [
    (  # at the time that the exercise names
        {
            _SENDS: f"{_SENDS}        if 3.0 < {_NOW} < 5.0:\n"
            "            self.get_logger().info('[DRIVER] other = joystick')\n            return\n",
        },
        "in place of the joystick, from 2 s to 3.5 s: from 2.6 s to 3.5 s the vehicle drove",
    ),
    (  # by the name that it has in the exercise
        {
            _SENDS: f"{_SENDS}        if self.count_publishers('cmd_vel') > 1:\n"
            "            self.get_logger().info('[DRIVER] other = joystick')\n            return\n",
        },
        "asked who else publishes on `cmd_vel`, the node printed `joystick`",
    ),
    ({}, "the vehicle drove"),
    ({"0.05, self": "0.01, self"}, "the vehicle drove"),
    ({"0.05, self": "0.25, self"}, "the vehicle drove"),
    (
        {_SENDS: f"{_SENDS}        if self.count_publishers('cmd_vel') > 1:\n            return\n"},
        "the node printed nothing",
    ),
    (
        {_SENDS: f"{_SENDS}        print('[DRIVER] other = joystick')\n"},
        "the vehicle drove",
    ),
    (
        {
            _SENDS: f"{_SENDS}        if self.count_publishers('cmd_vel') > 1:\n            rclpy.shutdown()\n"
            "            return\n"
        },
        "did not drive again",
    ),
    (
        {
            _SENDS: f"{_SENDS}        if self.count_publishers('cmd_vel') > 1:\n"
            "            print('[DRIVER] other =', self.get_name())\n"
            "            return\n"
        },
        "printed `driver_py_node`",
    ),
    ({_SENDS: f"{_SENDS}        if self.count_publishers('cmd_vel') > 0:\n            return\n"}, "command came on"),
]

SOLUTION_CPP = {
    "  void timerCallback()\n  {\n": "  void timerCallback()\n"
    "  {\n"
    '    for (const auto& end : get_publishers_info_by_topic("cmd_vel"))\n'
    "    {\n"
    "      if (end.node_name() != get_name())\n"
    "      {\n"
    '        RCLCPP_INFO_STREAM(get_logger(), "[DRIVER] other = " << end.node_name());\n'
    "        return;\n"
    "      }\n"
    "    }\n"
}

RIGHT_CPP = [
    {
        "        return;\n": "        is_other_ = true;\n        return;\n",
        "  double offset_": "  bool is_other_ = false;\n  double offset_",
    },
]
WRONG_CPP = [
    ({"        return;\n": ""}, "from 3.6 s to 5 s the vehicle drove", "send nothing"),
    ({"end.node_name());": "get_name());"}, "the node printed `driver_cpp_node`", "the publisher that is not yours"),
    (
        {"<< end.node_name()": '<< "joystick"'},
        "asked who else publishes on `cmd_vel`, the node printed `joystick`",
        "`node_name` of the publisher",
    ),
]
