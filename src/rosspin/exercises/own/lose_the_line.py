"""Between two commands the wheels stay as they are: too long, and the line is lost."""

from __future__ import annotations

from collections.abc import Iterator

from .. import Finding
from ..driving import TURNS, between, commands, driver_cpp, follows, one_publisher, steady
from ..judging import Answer, say

TITLE = "At which rate is it lost?"
TEXT = """
Commands take computing time, so send as few as you can: find the longest period, in steps of 0.05 s, with which the
vehicle stays on its line, at most 0.25 m off, for 8 s at 2 m/s.
"""
REVEALS = "Any rate will do. The faster, the better, and it costs nothing."

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
        self.create_timer(0.5, self.timer_callback)

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

NODE_CPP = driver_cpp("500ms")

HINTS = [
    "How far does the vehicle drive between two commands, in 0.5 s?",
    "Halve the period until the vehicle stays on its line, then lengthen it in steps of 0.05 s.",
]
HINTS_CPP = [
    "How far does the vehicle drive between two commands, in 0.5 s?",
    "Halve the period until the vehicle stays on its line, then lengthen it in steps of 50 ms.",
]

_SLOWEST = 0.3
_MIXED = "More is sent than one timer asks for: leave one timer, and let each call send one command."


def check(answer: Answer) -> Iterator[Finding]:
    """Whether the commands are as rare as they can be while the vehicle keeps to its line."""
    run = answer.run(8.0, beside=["vehicle"])
    rare = f"Its wheels are set every {say(between(run))}: too rarely. Make the period shorter."
    most = max((len(timer.calls) for timer in run.timers), default=0)
    mixed = _MIXED if len(commands(run)) > most + 1 else ""
    followed = follows(run, mixed or (TURNS if between(run) <= _SLOWEST else rare))
    yield followed
    if followed.right and not any(timer.calls for timer in run.timers):
        yield from steady(run, _SLOWEST)
    elif followed.right:
        if wrong := one_publisher(run):
            yield wrong
        text = f"{len(commands(run))} commands came in {say(run.seconds)}, one every {say(between(run))}."
        hint = "It still keeps to its line if they are rarer. Make the period longer, in steps of 0.05 s."
        steps = between(run) / 0.05
        if abs(steps - round(steps)) > 0.05:
            hint = f"{say(between(run))} is no multiple of 0.05 s. Which is the longest that keeps it on its line?"
        yield Finding(abs(between(run) - _SLOWEST) < 0.005 and not mixed, text, mixed or hint)


AFTER = """
Near the limit, a little more is not always worse: every 0.32 s, the commands happen to come at better places of the
bends than every 0.3 s.
"""

RIGHT = [
    {"0.5, self": "0.3, self"},
    {"0.5, self": "3 / 10, self"},
    {"0.5, self.timer_callback": "timer_period_sec=0.3, callback=self.timer_callback"},
    {
        "        self.create_timer(0.5, self.timer_callback)\n": "        self.ticks = 0\n"
        "        self.create_timer(0.05, self.timer_callback)\n",
        "    def timer_callback(self):\n": "    def timer_callback(self):\n        self.ticks += 1\n"
        "        if self.ticks % 6:\n            return\n",
    },
]
WRONG = [
    (
        {
            "        self.create_timer(0.5, self.timer_callback)\n": "        self.heard = 0\n",
            "self.offset = message.data\n": "self.offset = message.data\n        self.heard += 1\n"
            "        if self.heard % 6 == 0:\n            self.timer_callback()\n",
        },
        "No timer of the node sends the commands.",
    ),
    ({}, "leaves its line by 1.4 m"),
    ({"0.5, self": "0.35, self"}, "leaves its line"),
    ({"0.5, self": "0.25, self"}, "32 commands came in 8 s, one every 0.25 s"),
    ({"0.5, self": "0.2, self"}, "40 commands came in 8 s"),
    ({"0.5, self": "0.05, self"}, "160 commands came in 8 s, one every 0.05 s"),
    ({"0.5, self": "0.3, self", "8.0 *": "4.0 *"}, "Is the turn 8.0 times the newest offset"),
    (
        {
            "self.create_timer(0.5, self.timer_callback)\n": "self.create_timer(0.5, self.timer_callback)\n"
            "        self.create_timer(0.3, self.timer_callback)\n"
        },
        "leave one timer",
    ),
    (
        {
            "0.5, self": "0.3, self",
            "self.publisher.publish(command)\n": "self.publisher.publish(command)\n"
            "        self.publisher.publish(command)\n",
        },
        "let each call send one command",
    ),
    ({"0.5, self": "0.29, self"}, "0.29 s is no multiple of 0.05 s"),
    ({"0.5, self": "0.33, self"}, "0.33 s is no multiple of 0.05 s"),
    (
        {
            "0.5, self": "0.3, self",
            "import rclpy\n": "import time\n\nimport rclpy\n",
            "        command = Twist()\n": "        time.sleep(0.5)\n        command = Twist()\n",
        },
        "A timer's callback sleeps, at line 22",
    ),
    ({"0.5, self": "4.0, self"}, "leaves its line"),
    ({"linear.x = 2.0": "linear.x = 1.0"}, "Its speed was 1 m/s"),
    ({"0.5, self": "0.0, self"}, "is called without a pause"),
]

SOLUTION_CPP = {"500ms": "300ms"}

RIGHT_CPP = [
    {"300ms": "std::chrono::duration<double>(0.3)"},
]
WRONG_CPP = [
    ({"300ms": "350ms"}, "leaves its line", "Make the period shorter"),
    ({"300ms": "250ms"}, "32 commands came in 8 s, one every 0.25 s", "Make the period longer"),
    ({"= 2.0": "= 1.0"}, "the vehicle keeps to its line, but drove", "Its speed was 1 m/s"),
]
