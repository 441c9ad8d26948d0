"""A timer is what steers: without one, a node hears its sensor and does nothing."""

from __future__ import annotations

from collections.abc import Iterator

from .. import Finding
from ..driving import TURNS, follows, is_rare, steady
from ..judging import Answer

TITLE = "Follow the line"
TEXT = """
This node hears where the line is. Make it steer ten times a second, with a timer, so that the vehicle follows its line
for 8 s.
"""
REVEALS = "A node steers by itself once it has a publisher. A command that was sent once is enough."

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
        self.steer()

    def line_callback(self, message):
        self.offset = message.data

    def steer(self):
        command = Twist()
        command.linear.x = 2.0  # m/s
        command.angular.z = 8.0 * self.offset  # rad/s, to the left
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

NODE_CPP = """
#include <chrono>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float32.hpp"

using namespace std::chrono_literals;

class DriverCppNode : public rclcpp::Node
{
public:
  DriverCppNode() : Node("driver_cpp_node")
  {
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    subscription_ = create_subscription<std_msgs::msg::Float32>("line", 10,
        [this](const std_msgs::msg::Float32& message) { lineCallback(message); });
    steer();
  }

private:
  void lineCallback(const std_msgs::msg::Float32& message)
  {
    offset_ = message.data;
  }

  void steer()
  {
    geometry_msgs::msg::Twist command;
    command.linear.x = 2.0;  // m/s
    command.angular.z = 8.0 * offset_;  // rad/s, to the left
    publisher_->publish(command);
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr subscription_;
  double offset_ = 0.0;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<DriverCppNode>());
  rclcpp::shutdown();
  return 0;
}
"""

HINTS = [
    "How often is `steer` called, and when?",
    "`self.create_timer(period, callback)` calls the callback once each period.",
    "The period is 0.1 s, and the callback can be `self.steer` itself.",
]
HINTS_CPP = [
    "How often is `steer` called, and when?",
    "`create_wall_timer(period, callback)` calls the callback once each period. Keep what it returns.",
    "The period is `100ms`, and the callback `[this] { steer(); }`.",
]

_AGAIN = "Its wheels stay as they were told last. Tell them again, ten times a second."


def check(answer: Answer) -> Iterator[Finding]:
    """Whether a timer steers, and the vehicle keeps to its line."""
    run = answer.run(8.0, beside=["vehicle"])
    followed = follows(run, _AGAIN if is_rare(run) else TURNS)
    yield followed
    if followed.right:
        yield from steady(run, 0.1, run.loops)


_STEER = "        self.steer()\n"
_TIMER = "        self.create_timer(0.1, self.steer)\n"
_TIME = {"import rclpy\n": "import time\n\nimport rclpy\n"}
RIGHT = [
    {"        self.steer()\n": "        self.create_timer(0.1, self.steer)\n"},
    {"        self.steer()\n": "        self.timer = self.create_timer(1 / 10, lambda: self.steer())\n"},
    {
        "        self.steer()\n": "        self.create_timer(timer_period_sec=0.1, callback=self.steer)\n",
        "8.0 * self.offset": "9 * float(self.offset)",
    },
    {
        "        self.steer()\n": "        for period in (0.1,):\n            self.create_timer(period, self.steer)\n",
    },
    """
import rclpy
from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import Float32

rclpy.init()
node = rclpy.create_node("d")
heard = [0.0]
pub = node.create_publisher(Twist, "/cmd_vel", 1)
node.create_subscription(Float32, "/line", lambda m: heard.append(m.data), 1)
node.create_timer(0.1, lambda: pub.publish(Twist(linear=Vector3(x=2.0), angular=Vector3(z=8.0 * heard[-1]))))
rclpy.spin(node)
""",
]
WRONG = [
    ({_STEER: _TIMER.replace("0.1", "0.2") * 2}, "80 commands came in 8 s, two at a time"),
    (
        {_STEER: _TIMER, '        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)\n': ""}
        | {"        self.publisher.publish": '        self.create_publisher(Twist, "cmd_vel", 10).publish'},
        "The node made 80 publishers of `/cmd_vel`, where one would do",
    ),
    (
        {_STEER: _TIMER, '"cmd_vel", 10)': '"cmd_vel", qos_profile_sensor_data)'}
        | {"import rclpy\n": "import rclpy\nfrom rclpy.qos import qos_profile_sensor_data\n"},
        "The publisher offers less than the vehicle asks for",
    ),
    (
        {_STEER: _TIMER, "(Float32, ": "(Float64, ", "import Float32": "import Float64"},
        "Both have to name the same type, `Float32`",
    ),
    (
        {_STEER: _TIMER, "self.offset = message.data\n": "self.offset = message.data\n        self.steer()\n"},
        "Not all of the commands are sent by a timer of the node",
    ),
    (
        {_STEER: "        threading.Thread(target=self.loop, daemon=True).start()\n"}
        | {
            "    def steer(self):\n": "    def loop(self):\n        while rclpy.ok():\n            self.steer()\n"
            "            time.sleep(0.1)\n\n    def steer(self):\n"
        }
        | {"import rclpy\n": "import threading\nimport time\n\nimport rclpy\n"},
        "No timer of the node sends the commands: a loop does, at line 2",
    ),
    ({_STEER: _TIMER, "command = Twist()": "command = Twist"}, "Make an object of it, with `()`"),
    ({"        self.steer()\n": "        self.create_timer(10, self.steer)\n"}, "The timer's period is 10 s"),
    (
        {"        self.steer()\n": "        self.create_timer(0.1, self.steer)\n", "8.0 *": "0.5 *"},
        "Is the turn 8.0 times",
    ),
    ({}, "it did not reach the vehicle"),
    ({"self.steer()\n": "self.create_timer(0.1, self.steer())\n"}, "NoneType"),
    ({"self.steer()\n": "self.create_timer(1.0, self.steer)\n"}, "leaves its line"),
    ({"self.steer()\n": "self.create_timer(10, self.steer)\n"}, "command came on `/cmd_vel`"),
    (
        {"self.steer()\n": "self.create_timer(0.1, self.steer)\n", "8.0 * self.offset": "-8.0 * self.offset"},
        "It turns away from the line",
    ),
    (
        {"self.steer()\n": "self.create_timer(0.1, self.steer)\n", "x = 2.0": "x = 0.5"},
        "Its speed was 0.5 m/s",
    ),
    (
        {
            "        self.steer()\n": "",
            "self.offset = message.data\n": "self.offset = message.data\n        self.steer()\n",
        },
        "timer of the node sends the commands",
    ),
    (
        {"self.steer()\n": "self.create_timer(0.1, self.steer)\n", '"cmd_vel"': '"cmd_val"'},
        "It publishes on `/cmd_val`",
    ),
    (
        {"self.steer()\n": "self.create_timer(0.1, self.steer)\n", '"line"': '"lines"'},
        "It subscribes to `/lines`, and the vehicle says on `line`",
    ),
    ({_STEER: _TIMER, "self.offset = message": "offset = message"}, "by the same name, with its `self.`"),
    ({_STEER: _TIMER, "self.offset = message": "self.off = message"}, "by the same name, with its `self.`"),
    (
        {_STEER: "        while True:\n            self.steer()\n            time.sleep(0.1)\n"} | _TIME,
        "A loop, at line 18, keeps the node from `spin`",
    ),
    (
        {_STEER: _TIMER, "        command = Twist()\n": "        time.sleep(0.5)\n        command = Twist()\n"} | _TIME,
        "A timer's callback sleeps, at line 22",
    ),
    (
        {_STEER: _STEER + _TIMER, "        command = Twist()\n": f"{_TIMER}        command = Twist()\n"},
        "Each call of a callback makes one more timer",
    ),
    ({_STEER: _TIMER.replace("0.1", "0.2")}, "one every 0.2 s"),
    ({_STEER: _TIMER.replace("0.1", "0.01")}, "one every 0.01 s"),
    ({_STEER: _TIMER + _TIMER}, "160 commands came in 8 s"),
]

SOLUTION_CPP = {
    "    steer();\n": "    timer_ = create_wall_timer(100ms, [this] { steer(); });\n",
    "  double offset_": "  rclcpp::TimerBase::SharedPtr timer_;\n  double offset_",
}

RIGHT_CPP = [
    {"100ms": "std::chrono::milliseconds(100)"},
]
WRONG_CPP = [
    ({"100ms": "50ms"}, "one every 0.05 s", "10 times a second is one every 0.1 s"),
    ({"    offset_ = message": "    auto offset_ = message"}, "leaves its line", "a member of the object"),
    ({"timer_ = create": "auto timer = create"}, "no command came on `/cmd_vel`", "Does a timer publish"),
    ({"100ms": "500ms"}, "leaves its line by 1.4 m", "Tell them again, ten times a second"),
    ({"8.0 *": "-8.0 *"}, "leaves its line", "It turns away from the line"),
]
