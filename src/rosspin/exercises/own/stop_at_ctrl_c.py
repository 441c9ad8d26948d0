"""Ctrl-C ends the node, not the motor."""

from __future__ import annotations

from collections.abc import Iterator

from .. import Finding
from ..driving import commands, driver_cpp, follows, stands
from ..judging import Answer, say
from ..observed import ObservedRun

TITLE = "Stop at Ctrl-C"
TEXT = """
After 4 s Ctrl-C ends the node, but the vehicle follows its last command. Stop it within 0.2 s of Ctrl-C.
"""
REVEALS = "A vehicle stops when its node ends. After Ctrl-C a node can publish as before."

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
        self.create_timer(0.1, self.timer_callback)

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

NODE_CPP = driver_cpp("100ms")

HINTS = [
    "What does the vehicle do with the last command?",
    "At Ctrl-C, rclpy shuts its context down before your `except` is reached. Can the node publish after that?",
    "`rclpy.init(signal_handler_options=SignalHandlerOptions.NO)`, with `SignalHandlerOptions` from `rclpy.signals`: "
    "then Ctrl-C only raises KeyboardInterrupt. Publish a `Twist()` before the shutdown.",
]
HINTS_CPP = [
    "What does the vehicle do with the last command?",
    "At Ctrl-C, rclcpp shuts its context down before `spin` returns. Can the node publish after that?",
    "`rclcpp::contexts::get_global_default_context()->add_pre_shutdown_callback(function)` has a function called "
    "before the shutdown. It can publish a `Twist`.",
]

_AT, _EARLIER = 4.03, 2.53
_ON = "Its wheels stay as they were told last, whatever becomes of the node. Send a speed of 0 when Ctrl-C comes."
_LATE = (
    "After Ctrl-C the node published, but rclpy had shut down by then. Ask it to leave Ctrl-C to you: "
    "`rclpy.init(signal_handler_options=SignalHandlerOptions.NO)`."
)


def check(answer: Answer) -> Iterator[Finding]:
    """Whether the vehicle is driven until Ctrl-C, whenever that comes, and stops then."""
    findings = list(_stops(answer.run(8.0, beside=["vehicle"], interrupted_at=_AT), _AT))
    yield from findings
    if all(finding.right for finding in findings):
        for finding in _stops(answer.run(4.0, beside=["vehicle"], interrupted_at=_EARLIER), _EARLIER):
            if not finding.right:
                yield finding._replace(text=f"Ctrl-C at {say(_EARLIER)}: {finding.text}")


def _stops(run: ObservedRun, at: float) -> Iterator[Finding]:
    """Whether the vehicle is driven until Ctrl-C, which comes at a time (s), and stops then."""
    driven = follows(run, "Until Ctrl-C, steer as before.", 0.0, at)
    yield driven
    if not driven.right:
        return
    if not run.interrupted:
        yield Finding(False, f"the node had ended before Ctrl-C came, at {say(at)}.", "It drives until Ctrl-C ends it.")
        return
    is_late = any("context is invalid" in error.said or "publisher" in error.said.lower() for error in run.errors)
    stopped = stands(run, at + 0.2, run.seconds, _LATE if is_late else _ON)
    after = commands(run, at)
    if after and after[-1].speed:
        hint = "A speed of 0 has to be the last command of all: a new `Twist` is all zeros."
        text = f"the last command, at {say(after[-1].time)}, has a speed of {after[-1].speed:g} m/s."
        stopped = Finding(False, text, hint)
    yield stopped


_OPTIONS = "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)"
_NO = {
    "from rclpy.node import Node\n": "from rclpy.node import Node\nfrom rclpy.signals import SignalHandlerOptions\n",
    "rclpy.init()": _OPTIONS,
}
_STOPS = {"    finally:\n": "    finally:\n        driver_py_node.publisher.publish(Twist())\n"}
RIGHT = [
    _NO | _STOPS,
    _NO
    | {
        "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n": "    except KeyboardInterrupt:\n"
        "        driver_py_node.publisher.publish(Twist())\n",
    },
    {  # a handler of one's own
        "import rclpy\n": "import signal\n\nimport rclpy\n",
        "    try:\n": "    signal.signal(signal.SIGINT, driver_py_node.stop)\n    try:\n",
        "    def line_callback": "    def stop(self, number, frame):\n        self.publisher.publish(Twist())\n"
        "        rclpy.try_shutdown()\n\n    def line_callback",
    },
    {  # before the context is shut down
        "        self.create_timer": "        self.context.on_shutdown(self.stop)\n        self.create_timer",
        "    def line_callback": "    def stop(self):\n        pass\n\n    def line_callback",
    }
    | _NO
    | {
        "    finally:\n": "    finally:\n        for _ in range(3):\n"
        "            driver_py_node.publisher.publish(Twist())\n"
    },
    {
        "rclpy.init()\n    driver_py_node = DriverPyNode()\n": f"{_OPTIONS}\n    driver_py_node = DriverPyNode()\n",
        "from rclpy.node import Node\n": "from rclpy.node import Node\n"
        "from rclpy.signals import SignalHandlerOptions\n",
        "        rclpy.spin(driver_py_node)\n": "        while True:\n            rclpy.spin_once(driver_py_node)\n",
        "        pass\n": "        stop = Twist()\n        stop.linear.x = 0.0\n"
        "        driver_py_node.publisher.publish(stop)\n",
    },
]
WRONG = [
    (  # before Ctrl-C, at the time that the exercise names
        {
            "        command = Twist()\n": "        command = Twist()\n"
            "        if self.get_clock().now().nanoseconds >= 4e9:\n"
            "            self.publisher.publish(command)\n            return\n",
        },
        "Ctrl-C at 2.53 s: from 2.73 s to 4 s the vehicle drove",
    ),
    ({}, "the vehicle drove"),
    (_STOPS, "rclpy had shut down by then"),
    ({"        pass\n": "        driver_py_node.publisher.publish(Twist())\n"}, "rclpy had shut down by then"),
    (_NO, "the vehicle drove"),
    ({"    finally:\n": "    finally:\n        driver_py_node.destroy_node()\n"}, "the vehicle drove"),
    (
        _NO
        | {
            "        rclpy.try_shutdown()\n": "        rclpy.try_shutdown()\n"
            "        driver_py_node.publisher.publish(Twist())\n"
        },
        "the vehicle drove",
    ),
    (
        _NO
        | {
            "        pass\n": "        command = Twist()\n        command.linear.x = 2.0\n"
            "        driver_py_node.publisher.publish(command)\n"
        },
        "has a speed of 2 m/s",
    ),
]

SOLUTION_CPP = {
    "    timer_ = create": "    auto context = rclcpp::contexts::get_global_default_context();\n"
    "    context->add_pre_shutdown_callback([this]\n"
    "    {\n"
    "      timer_->cancel();\n"
    "      publisher_->publish(geometry_msgs::msg::Twist());\n"
    "    });\n"
    "    timer_ = create"
}

RIGHT_CPP = [
    {"rclcpp::contexts::get_global_default_context()": "get_node_base_interface()->get_context()"},
]
WRONG_CPP = [
    (
        {"add_pre_shutdown_callback": "add_on_shutdown_callback"},
        "from 4.23 s to 8 s the vehicle drove",
        "Send a speed of 0 when Ctrl-C comes",
    ),
    (
        {"      publisher_->publish(geometry_msgs::msg::Twist());\n": ""},
        "from 4.23 s to 8 s the vehicle drove",
        "Send a speed of 0 when Ctrl-C comes",
    ),
    (
        {"geometry_msgs::msg::Twist());\n    });": "geometry_msgs::msg::Twist());\n      timerCallback();\n    });"},
        "the last command, at 4.03 s, has a speed of 2 m/s",
        "has to be the last command",
    ),
]
