"""A number is a message: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Publish a counter"
TEXT = """
**You need**: [publish and subscribe in ROS 2](../docs/ros2/publish.rst) and [its notebook](ros2-publish.md).

This node listens for `std_msgs/msg/UInt32` messages on the topic `counter`. Make its timer publish 1, 2, 3 and so on
there, five times a second, beginning one period after the start. A subscriber in another process has to be sure to hear
the first message, too. Do not change the subscription.
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

NODE_CPP = """
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int32.hpp"

using namespace std::chrono_literals;

class RobotCppNode : public rclcpp::Node
{
public:
  RobotCppNode() : Node("robot_cpp_node")
  {
    subscription_ = create_subscription<std_msgs::msg::UInt32>("counter", 10,
        [this](const std_msgs::msg::UInt32& message) { counterCallback(message); });
    timer_ = create_wall_timer(500ms, [this] { timerCallback(); });
  }

private:
  void timerCallback()
  {
    counter_++;
  }

  void counterCallback(const std_msgs::msg::UInt32& message)
  {
    RCLCPP_INFO_STREAM(get_logger(), "[LISTENER] counter = " << message.data);
  }

  unsigned int counter_ = 0;
  rclcpp::Subscription<std_msgs::msg::UInt32>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<RobotCppNode>());
  return 0;
}
"""

HINTS = [
    "Two things are missing: the publisher, and a line in the timer's callback that uses it. Where does each belong?",
    "`self.create_publisher` takes the type of the messages, the name of the topic, and how many "
    "messages may wait: 10.",
    "A number is not a message: `UInt32(data=self.counter)` is. And a new publisher may not "
    "be connected to other processes yet.",
]
HINTS_CPP = [
    "Two things are missing: the publisher, and lines in the timer's callback that use it. Where does each belong?",
    "`create_publisher<Type>` is given the name of the topic, and how many messages may wait: 10. A member of the "
    "class keeps what it returns.",
    "A number is not a message: make a `std_msgs::msg::UInt32`, and set its `data`. And a new publisher may not "
    "be connected to other processes yet.",
]
HINT = 'Make a `self.create_publisher(UInt32, "counter", 10)` in `__init__`, and publish in the callback.'
HINT_CPP = (
    'Make the publisher in the constructor, `create_publisher<std_msgs::msg::UInt32>("counter", 10)`, and publish in '
    "the callback."
)

check = by.published_and_heard

SOLUTION = {
    "        self.counter = 0\n": "        self.counter = 0\n"
    '        self.publisher = self.create_publisher(UInt32, "counter", 10)\n',
    "0.5": "0.2",
    "        self.counter += 1\n": "        self.counter += 1\n"
    "        self.publisher.publish(UInt32(data=self.counter))\n",
}

AFTER = """
A publisher that is made in the callback mostly works, too. Whether the listener in another process knows it in time is
left to chance, on the real `rclpy` as well, so a test easily misses that a message is lost.
"""

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
LOOPS = "        while rclpy.ok():\n            self.count()\n            time.sleep(0.2)\n\n    def count(self):\n"
WRONG = [
    (
        {"self.counter_callback, 10)": "self.counter_callback, qos_profile_sensor_data)"}
        | {"import rclpy\n": "import rclpy\nfrom rclpy.qos import qos_profile_sensor_data\n"},
        "the listener now has best_effort, volatile, depth 5, where it had reliable, volatile, depth 10",
        "Leave the listener as it is",
    ),
    (
        {
            '        self.create_subscription(UInt32, "counter", self.counter_callback, 10)\n': "",
            "        self.counter += 1\n": "        self.counter += 1\n        if self.counter == 1:\n"
            '            self.create_subscription(UInt32, "counter", self.counter_callback, 10)\n',
        },
        "the listener subscribes only at 0.2 s",
        "Leave the listener as it is",
    ),
    (
        {PUBLISHES: "        message = UInt32()\n        message.Data = 1\n"},
        "'UInt32' object has no attribute 'Data'",
        "Fields are written in small letters",
    ),
    (
        {"        self.publisher = self": "        publisher = self", "self.publisher.pub": "publisher.pub"},
        "name 'publisher' is not defined",
        "kept as `self.publisher`",
    ),
    (
        {PUBLISHES: "        message = UInt32\n        message.data = 1\n        self.publisher.publish(message)\n"},
        "TypeError",
        "make one, with `()`",
    ),
    (
        {
            "    def timer_callback(self):\n": f"    def timer_callback(self):\n{LOOPS}",
            "import rclpy\n": "import time\nimport rclpy\n",
        },
        "a call of the timer's callback had not returned in the end",
        by.RETURNS,
    ),
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

MAKES_CPP = '    publisher_ = create_publisher<std_msgs::msg::UInt32>("counter", 10);\n'
PUBLISHES_CPP = "    std_msgs::msg::UInt32 message;\n    message.data = counter_;\n    publisher_->publish(message);\n"
KEEPS_CPP = "  rclcpp::Publisher<std_msgs::msg::UInt32>::SharedPtr publisher_;\n"
LISTENS_CPP = (
    '    subscription_ = create_subscription<std_msgs::msg::UInt32>("counter", 10,\n'
    "        [this](const std_msgs::msg::UInt32& message) { counterCallback(message); });\n"
)

SOLUTION_CPP = {
    LISTENS_CPP: MAKES_CPP + LISTENS_CPP,
    "500ms": "200ms",
    "    counter_++;\n": "    counter_++;\n" + PUBLISHES_CPP,
    "  rclcpp::TimerBase::SharedPtr timer_;\n": f"{KEEPS_CPP}  rclcpp::TimerBase::SharedPtr timer_;\n",
}

RIGHT_CPP = [
    {
        PUBLISHES_CPP: "    auto message = std::make_unique<std_msgs::msg::UInt32>();\n    message->data = counter_;\n"
        "    publisher_->publish(std::move(message));\n"
    },
    {'Int32>("counter", 10);': 'Int32>("/counter", rclcpp::QoS(1));'},
    {"200ms": "std::chrono::duration<double>(1 / 5.0)"},
    {PUBLISHES_CPP: "    publisher_->publish(std_msgs::msg::UInt32().set__data(counter_));\n"},
]
WRONG_CPP = [
    (
        {
            "  void timerCallback()\n": "  void timerCallback()\n  {\n    while (rclcpp::ok()) {\n      count();\n"
            "      rclcpp::sleep_for(200ms);\n    }\n  }\n\n  void count()\n"
        },
        "a call of the timer's callback had not returned in the end",
        by.RETURNS,
    ),
    (
        {MAKES_CPP: "", PUBLISHES_CPP: MAKES_CPP + PUBLISHES_CPP},
        "the node made 10 publishers of `/counter`",
        "Make it once, before the timer",
    ),
    (
        {MAKES_CPP: "", PUBLISHES_CPP: f"    if (!publisher_)\n  {MAKES_CPP}{PUBLISHES_CPP}"},
        "the publisher was made at 0.2 s",
        "Make it once, before the timer",
    ),
    (
        {MAKES_CPP: ""},
        "stopped in line 25: `it has used a null pointer`",
        "Something that the node uses there was not made yet, or has",
    ),
    (
        {"    publisher_->publish(message);\n": ""},
        "on `/counter`: the node published nothing",
        "nothing publishes with it",
    ),
    (
        {"    message.data = counter_;\n": ""},
        "on `/counter`: each message holds 0, not a counter.",
        "A new message holds 0.",
    ),
    ({'Int32>("counter", 10);': 'Int32>("count", 10);'}, "it was published on `/count`", "letter by letter"),
    (
        {'Int32>("counter", 10);': 'Int32>("~/counter", 10);'},
        "it was published on `/robot_cpp_node/counter`",
        "letter by letter",
    ),
    (
        {"200ms": "500ms"},
        "On `/counter`: counter 1 came at 0.5 s, not at 0.2 s",
        "Five times a second is once in 1 / 5 s.",
    ),
    ({"200ms": "5s"}, "nothing was published on `/counter`", "Five times a second is once in 1 / 5 s."),
    (
        {'Int32>("counter", 10);': 'Int32>("counter", rclcpp::SensorDataQoS());'},
        "The listener: no counter was printed",
        "offers less than the listener asks for",
    ),
    (
        {"    counter_++;\n" + PUBLISHES_CPP: PUBLISHES_CPP + "    counter_++;\n"},
        "where counter 1 was due, counter 0 came",
        "The first counter is 1:",
    ),
    (
        {LISTENS_CPP: "", PUBLISHES_CPP: PUBLISHES_CPP + "    counterCallback(message);\n"},
        "The listener: its lines were printed in a call of a timer",
        "A topic carries the message",
    ),
    (
        {"[LISTENER] counter": "[LISTENER] number"},
        "The listener: no counter was printed",
        "Leave the listener as it is",
    ),
    ({LISTENS_CPP: ""}, "The listener: no counter", "Nothing subscribes to `/counter` any more."),
    (
        {"publish(message)": "publish(counter_)"},
        "does not compile",
        "publish() takes a message: set the field of one",
    ),
]
