"""The wheels stay as they were told last: a node that hears nothing any more has to stop them."""

from __future__ import annotations

from collections.abc import Iterator

from .. import Finding
from ..driving import commands, driver_cpp, follows, stands
from ..judging import Answer, say
from ..observed import ObservedRun

TITLE = "Stop when blind"
TEXT = """
From 3 s to 5 s the sensor is silent. Stop the vehicle when nothing has come for 0.5 s, not earlier and at most 0.1 s
later, and drive on when the sensor is back.
"""
REVEALS = "A node notices by itself that no message comes. A callback that is not called can do something."

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
    "Which callback is still called while the sensor is silent?",
    "Keep the time, `self.get_clock().now()`, whenever a message comes.",
    "In `timer_callback`: `silence = self.get_clock().now() - self.heard`, and `silence > Duration(seconds=0.5)`, with "
    "`Duration` from `rclpy.duration`. A new `Twist` is all zeros, and stops the vehicle.",
]
HINTS_CPP = [
    "Which callback is still called while the sensor is silent?",
    "Keep the time, `now()`, whenever a message comes, in an `rclcpp::Time`.",
    "In `timerCallback`: `now() - heard_ > rclcpp::Duration(500ms)`. A new `Twist` is all zeros: it stops the vehicle.",
]

_SILENT_AT, _PATIENCE = (3.0, 5.0), 0.5  # when the sensor is silent, and how long (s) that may be
_STOP = (
    "Its wheels stay as they were told last. Send a `Twist` with a speed of 0 when nothing has come for 0.5 s: the "
    "timer can look how long ago the last message was."
)
_STEER = (
    "While messages come, steer as before. Is the time of the last one kept whenever one comes, where the timer "
    "looks for it?"
)
_BOTH = "A stop is sent, and then a command that drives on: send one of the two in each call."
_ALWAYS = (
    "It is stopped in each call. Is the silence compared in its own unit? A difference of two times is a `Duration`: "
    "compare it with one of 0.5 s. Its `nanoseconds` are billionths of a second."
)
_MUTE = "To send nothing is not to stop: its wheels stay as they were told last. Send a `Twist` with a speed of 0."


def check(answer: Answer) -> Iterator[Finding]:
    """Whether it stops half a second after the last message, whenever that was, and drives on with the next one."""
    findings = list(_stops(answer.run(8.0, beside=["silent vehicle"]), *_SILENT_AT))
    yield from findings
    if all(finding.right for finding in findings):
        for finding in _stops(answer.run(5.0, beside=["vehicle, silent earlier"]), 2.0, 3.5):
            if not finding.right:
                yield finding._replace(text=f"Silent from 2 s to 3.5 s: {finding.text}")


def _stops(run: ObservedRun, first: float, last: float) -> Iterator[Finding]:
    """Whether it stops half a second after the last message, not earlier, and drives on with the next one."""
    before = follows(run, _STEER, 0.0, first)
    sent = commands(run)
    yield before if not sent or any(each.speed for each in sent) else before._replace(hint=_ALWAYS)
    if not before.right:
        return
    due = first - 0.05 + _PATIENCE
    stopped = [command.time for command in commands(run, first - 0.05) if not command.speed and not command.turn]
    early = [time for time in stopped if time < due - 0.06]
    if early:
        hint = "20 messages a second come 0.05 s apart. Wait until nothing has come for 0.5 s."
        yield Finding(False, f"the vehicle was stopped at {say(early[0])}, earlier than 0.5 s after a message.", hint)
        return
    if stopped and due + 0.11 < stopped[0] < last:
        late = say(stopped[0] - first + 0.05)
        text = f"the vehicle was stopped at {say(stopped[0])}, {late} after the last message."
        yield Finding(False, text, "It should be stopped when nothing has come for 0.5 s.")
        return
    silent = commands(run, due + 0.11, last)
    hint = _BOTH if any(not each.speed for each in silent) else _STOP if silent else _MUTE
    yield stands(run, due + 0.11, last, hint)
    again = [command for command in commands(run, last + 0.01, last + 1.0) if command.speed]
    if not again:
        hint = "When messages come again, steer again: look at each tick how long ago the last one was."
        yield Finding(False, f"the sensor was back at {say(last)}, but the vehicle was not driven again.", hint)
    else:
        yield Finding(True, f"from {say(again[0].time)} on it drives again.")


_NOW = "self.get_clock().now()"
_SILENT = "    def timer_callback(self):\n        command = Twist()\n"
_HEARD = {
    "self.offset = 0.0\n": f"self.offset = 0.0\n        self.heard = {_NOW}\n",
    "self.offset = message.data\n": f"self.offset = message.data\n        self.heard = {_NOW}\n",
}
_IMPORT = {"import rclpy\n": "import rclpy\nfrom rclpy.duration import Duration\n"}
_LOOKS = (
    f"{_SILENT}        if {_NOW} - self.heard > Duration(seconds=0.5):\n"
    "            self.publisher.publish(command)\n            return\n"
)
_HEARD_ONCE = {"self.offset = 0.0\n": f"self.offset = 0.0\n        self.heard = {_NOW}\n"}
_IN_NS = f"({_NOW} - self.heard).nanoseconds > 0.5"
RIGHT = [
    _IMPORT | _HEARD | {_SILENT: _LOOKS},
    {
        "import rclpy\n": "import time\n\nimport rclpy\n",
        "self.offset = 0.0\n": "self.offset, self.heard = 0.0, time.monotonic()\n",
        "self.offset = message.data\n": "self.offset, self.heard = message.data, time.monotonic()\n",
        "command.linear.x = 2.0": "command.linear.x = 2.0 * (time.monotonic() - self.heard < 0.5)",
        "8.0 * self.offset": "8.0 * self.offset * bool(command.linear.x)",
    },
    {  # a timer that each message sets back
        "        self.create_timer(0.05": "        self.watchdog = self.create_timer(0.5, self.stop)\n"
        "        self.blind = False\n        self.create_timer(0.05",
        "self.offset = message.data\n": "self.offset = message.data\n        self.blind = False\n"
        "        self.watchdog.reset()\n\n    def stop(self):\n        self.blind = True\n"
        "        self.publisher.publish(Twist())\n",
        "    def timer_callback(self):\n": "    def timer_callback(self):\n"
        "        if self.blind:\n            return\n",
    },
    {  # counting ticks
        "self.offset = 0.0\n": "self.offset = 0.0\n        self.missed = 0\n",
        "self.offset = message.data\n": "self.offset = message.data\n        self.missed = 0\n",
        "        self.publisher.publish(command)\n": "        self.missed += 1\n"
        "        self.publisher.publish(command if self.missed <= 10 else Twist())\n",
    },
]
WRONG = [
    (  # at the time that the exercise names
        {
            _SILENT: f"{_SILENT}        if 3.46 < {_NOW}.nanoseconds / 1e9 < 5.0:\n"
            "            self.publisher.publish(command)\n            return\n"
        },
        "Silent from 2 s to 3.5 s: from 2.56 s to 3.5 s the vehicle drove",
    ),
    ({}, "the vehicle drove"),
    (_IMPORT | {_SILENT: _LOOKS} | _HEARD_ONCE, "It was stopped at 0.55 s. While messages come, steer as before"),
    (_IMPORT | _HEARD | {_SILENT: _LOOKS.replace("            return\n", "")}, "A stop is sent, and then a command"),
    (_IMPORT | _HEARD | {_SILENT: _LOOKS.replace("seconds=0.5", "0.5")}, "`Duration(seconds=0.5)`"),
    (_IMPORT | _HEARD | {_SILENT: _LOOKS.replace("seconds=", "sec=")}, "`Duration(seconds=0.5)`"),
    (_HEARD | {_SILENT: _LOOKS}, "`from rclpy.duration import Duration`"),
    (
        _IMPORT | _HEARD | {"self.offset = 0.0\n": "self.offset = 0.0\n        self.heard = 0\n", _SILENT: _LOOKS},
        "Both have to be times",
    ),
    (
        _HEARD | {_SILENT: _LOOKS, "import rclpy\n": "import rclpy\nfrom builtin_interfaces.msg import Duration\n"},
        "from rclpy.duration import Duration",
    ),
    (_HEARD | {_SILENT: _LOOKS.replace("Duration(seconds=0.5)", "0.5")}, "`Duration(seconds=0.5)`"),
    (
        _HEARD | {_SILENT: _LOOKS.replace(f"{_NOW} - self.heard > Duration(seconds=0.5)", _IN_NS)},
        "Its `nanoseconds` are billionths of a second",
    ),
    (
        _IMPORT | _HEARD | {_SILENT: _LOOKS.replace("            self.publisher.publish(command)\n", "")},
        "To send nothing",
    ),
    (_IMPORT | _HEARD | {_SILENT: _LOOKS.replace("0.5", "0.05")}, "earlier than 0.5 s after a message"),
    (_IMPORT | _HEARD | {_SILENT: _LOOKS.replace("0.5", "1.5")}, "1.55 s after the last message"),
    (
        _IMPORT | _HEARD | {_SILENT: _LOOKS.replace("            return", "            raise SystemExit")},
        "was not driven again",
    ),
    (
        {
            "self.offset = message.data\n": "self.offset = message.data\n        if message.data is None:\n"
            "            self.publisher.publish(Twist())\n"
        },
        "the vehicle drove",
    ),
    ({"command.linear.x = 2.0": "command.linear.x = 2.0 if self.offset else 0.0"}, "the vehicle drove"),
]

SOLUTION_CPP = {
    "    offset_ = message.data;\n": "    offset_ = message.data;\n    heard_ = now();\n",
    "    geometry_msgs::msg::Twist command;\n": "    geometry_msgs::msg::Twist command;\n"
    "    if (now() - heard_ > rclcpp::Duration(500ms))\n"
    "    {\n"
    "      publisher_->publish(command);\n"
    "      return;\n"
    "    }\n",
    "  double offset_ = 0.0;\n": "  rclcpp::Time heard_ = now();\n  double offset_ = 0.0;\n",
}

RIGHT_CPP = [
    {"rclcpp::Duration(500ms)": "rclcpp::Duration::from_seconds(0.5)"},
]
WRONG_CPP = [
    (
        {"      publisher_->publish(command);\n      return;": "      return;"},
        "from 3.56 s to 5 s the vehicle drove",
        "To send nothing is not to stop",
    ),
    ({"500ms": "1s"}, "1.05 s after the last message", "It should be stopped"),
    ({"500ms": "100ms"}, "earlier than 0.5 s after a message", "Wait until nothing has come"),
]
