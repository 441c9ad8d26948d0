"""A timer is given a frequency: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Make it 10 Hz"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md).

The timer of this node ticks twice a second. Make it tick 10 times a second.
"""
REVEALS = "A timer is given a frequency."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.create_timer(0.5, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    try:
        rclpy.spin(spinner_py_node)
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

using namespace std::chrono_literals;

class SpinnerCppNode : public rclcpp::Node
{
public:
  SpinnerCppNode() : Node("spinner_cpp_node")
  {
    timer_ = create_wall_timer(500ms, [this] { timerCallback(); });
  }

private:
  void timerCallback()
  {
    counter_++;
    RCLCPP_INFO_STREAM(get_logger(), "[SPINNER CPP NODE] counter = " << counter_);
  }

  unsigned int counter_ = 0;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SpinnerCppNode>());
  return 0;
}
"""

HINTS = [
    "Is the first argument of `create_timer` a frequency, or the time from one call to the next?",
    "It is the period, in seconds. How many seconds is a period of 10 Hz?",
    "The period is 1 divided by the frequency: 1 / 10.",
]
HINTS_CPP = [
    "Is the first argument of `create_wall_timer` a frequency, or the time from one call to the next?",
    "It is the period, with its unit: `500ms` is half a second. How long is a period of 10 Hz?",
    "The period is 1 divided by the frequency: 1 s / 10.",
]
HINT = "Ten times a second is once in 1 / 10 s: a timer takes a period, in seconds, and the period is 1 / frequency."
HINT_CPP = (
    "Ten times a second is once in 100 ms: a timer takes a period, with its unit, and the period is 1 / frequency."
)

check = by.run(1.0, by.ticks(0.1), by.from_timers())

SOLUTION = {"0.5": "0.1"}

SAYS = '        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))\n'
SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"
PLAIN = """import sys
import rclpy
rclpy.init()
node = rclpy.create_node("n")
count = 0
def callback():
    global count
    count += 1
    node.get_logger().info("[SPINNER PY NODE] counter = %d" % count)
MADE
rclpy.spin(node)
"""
MAKES = "self.create_timer(0.1, self.timer_callback)"
NOT_HZ = "the period is 1 / frequency"

RIGHT = [
    {SAYS: '        print(f"[SPINNER PY NODE]  counter={self.counter}")\n'},
    {MAKES: "self.create_timer(1 / 10, self.timer_callback)"},
    {MAKES: "self.create_timer(timer_period_sec=0.1, callback=self.timer_callback)"},
    {MAKES: "self.timer = self.create_timer(0.1, lambda: self.timer_callback())"},
    {TRY: "    rclpy.spin(spinner_py_node)\n"},
    {TRY: "    while rclpy.ok():\n        rclpy.spin_once(spinner_py_node)\n"},
    PLAIN.replace("MADE", "node.create_timer(0.1, callback)"),
]
LOOPS = "        while rclpy.ok():\n            self.count()\n            time.sleep(0.1)\n\n    def count(self):\n"
WRONG = [
    (
        {
            MAKES: MAKES.replace("self.create", "self.timer = self.create"),
            SAYS: f"{SAYS}        if self.counter == 10:\n            self.timer.cancel()\n",
        },
        "at 1 s no timer runs any more that printed the counters",
        "calls back until the node ends",
    ),
    ({MAKES: MAKES.replace("self.create", "create", 1)}, "name 'create_timer'", "it is `self.create_timer`"),
    (
        {MAKES: MAKES.replace("0.1", "0.2"), SAYS: f"{SAYS}        self.counter += 1\n{SAYS}"},
        "5 calls of a timer's callback printed 10 counters: a loop is in it",
        by.RETURNS,
    ),
    (
        {
            "    def timer_callback(self):\n": f"    def timer_callback(self):\n{LOOPS}",
            "import rclpy\n": "import time\nimport rclpy\n",
        },
        "one call of a timer's callback printed counters 1 to 10",
        by.RETURNS,
    ),
    (
        {MAKES: f"self.create_timer(0.5, self.timer_callback)\n        {MAKES}"},
        "came at 0.5 s, not at 0.6 s",
        "Timers with different periods print these counters, 0.1 s and 0.5 s",
    ),
    (
        {SAYS: f"{SAYS}        time.sleep(0.2)\n", "import rclpy\n": "import time\n\nimport rclpy\n"},
        "counter 2 came at 0.3 s, not at 0.2 s",
        "The callback sleeps, at line 17",
    ),
    (
        {
            f"        {MAKES}\n": "",
            SPIN: "        while rclpy.ok():\n            time.sleep(0.1)\n"
            "            spinner_py_node.timer_callback()\n",
            "import rclpy\n": "import time\n\nimport rclpy\n",
        },
        "counter 1 was not printed by the callback of a timer",
        "Keep the timer",
    ),
    (
        {"(self):\n        self.counter += 1": "():\n        self.counter += 1"},
        "takes 0 positional arguments but 1 was given",
        "def timer_callback(self)",
    ),
    ({MAKES: f"{MAKES}\n        {MAKES}"}, "counter 2 came at 0.1 s, not at 0.2 s", "two at a time"),
    ({MAKES: "self.create_timer(0,1, self.timer_callback)"}, "no attribute 'add_entity'", "`0,1` is two numbers"),
    ({MAKES: "self.createTimer(0.1, self.timer_callback)"}, "attribute 'createTimer'", "There is a `create_timer`"),
    ({MAKES: "self.create_timer(0.1, timer_callback)"}, "name 'timer_callback'", "it is `self.timer_callback`"),
    ({"import rclpy\n": "import rclpy\nimport no_module\n"}, "No module named", "Is the module spelt right?"),
    (
        {"(self):\n        super()": "(self):\n        self.t = None  # super()"},
        "has no attribute",
        "begins its __init__",
    ),
    ({MAKES: "self.create_timer(10, self.timer_callback)"}, "no counter was printed", NOT_HZ),
    ({MAKES: "self.create_timer(10.0, self.timer_callback)"}, "no counter was printed", NOT_HZ),
    ({"(0.1,": "(0.5,"}, "counter 1 came at 0.5 s, not at 0.1 s", NOT_HZ),
    ({"(0.1,": "(0.01,"}, "counter 1 came at 0.01 s, not at 0.1 s", NOT_HZ),
    (
        {"(0.1,": "(1 // 10,"},
        "The node has a timer whose period is 0 s: it is called without a pause",
        "In Python `1 // 10` is 0, and `1 / 10` is 0.1.",
    ),
    ({"(0.1,": "(-0.1,"}, "timer period must be non-negative", "cannot be negative"),
    ({"+= 1": "+= 10"}, "where counter 1 was due, counter 10 came", "The counter goes up by 10 each time:"),
    ({TRY: ""}, "no counter was printed", "The node ended by itself"),
    ({"self.timer_callback)": "self.timer_callback())"}, "'NoneType' object is not callable", "without calling it"),
    (
        {"(self):\n        self.counter += 1": "(self, event):\n        self.counter += 1"},
        "TypeError",
        "no argument",
    ),
]

MAKES_CPP = "create_wall_timer(100ms, [this] { timerCallback(); });"
SAYS_CPP = 'RCLCPP_INFO_STREAM(get_logger(), "[SPINNER CPP NODE] counter = " << counter_);'
SPIN_CPP = "  rclcpp::spin(std::make_shared<SpinnerCppNode>());\n"
PLAIN_CPP = """#include "rclcpp/rclcpp.hpp"
#include <cstdio>
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("n");
  int count = 0;
  auto timer = rclcpp::create_timer(node, node->get_clock(), rclcpp::Duration::from_seconds(0.1),
      [&] { std::printf("[SPINNER CPP NODE] counter = %d\\n", ++count); });
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
}
"""

SOLUTION_CPP = {"500ms": "100ms"}

RIGHT_CPP = [
    {"100ms": "std::chrono::milliseconds(100)"},
    {"100ms": "std::chrono::duration<double>(1 / 10.0)"},
    {MAKES_CPP: "create_wall_timer(0.1s, std::bind(&SpinnerCppNode::timerCallback, this));"},
    {MAKES_CPP: "create_timer(100ms, [this]() -> void { this->timerCallback(); });"},
    {SAYS_CPP: 'RCLCPP_INFO(this->get_logger(), "[SPINNER CPP NODE] counter = %u", counter_);'},
    PLAIN_CPP,
]
WRONG_CPP = [
    (
        {
            "  void timerCallback()\n": "  void timerCallback()\n  {\n    while (rclcpp::ok()) {\n      count();\n"
            "      rclcpp::sleep_for(100ms);\n    }\n  }\n\n  void count()\n"
        },
        "one call of a timer's callback printed counters 1 to 10",
        by.RETURNS,
    ),
    ({"100ms": "10s"}, "no counter was printed", NOT_HZ),
    ({"100ms": "10ms"}, "counter 1 came at 0.01 s, not at 0.1 s", NOT_HZ),
    ({"100ms": "500ms"}, "counter 1 came at 0.5 s, not at 0.1 s", NOT_HZ),
    ({"100ms": "10"}, "Line 13, column 14, does not compile: `no matching member function", "A period has a unit"),
    ({"100ms": "std::chrono::seconds(1 / 10)"}, "a timer whose period is 0 s", "In C++, `1 / 10` is 0"),
    ({"100ms": "-100ms"}, "timer period cannot be negative", "A period cannot be negative"),
    (
        {MAKES_CPP: f"{MAKES_CPP}\n    other_ = {MAKES_CPP}", "SharedPtr timer_;": "SharedPtr timer_, other_;"},
        "counter 2 came at 0.1 s",
        "two at a time",
    ),
    ({"timer_ = create": "auto timer = create"}, "no counter was printed", "was stopped before its first call"),
    ({"[this]": "[]"}, "does not compile: `'this' cannot be implicitly captured", "write [this] in place of []"),
    ({"counter_++;": "counter_++"}, "does not compile: `expected ';'", "A ; is missing"),
    (
        {"counter_++;": "counter_ += 10;"},
        "where counter 1 was due, counter 10 came",
        "The counter goes up by 10 each time:",
    ),
    ({SPIN_CPP: ""}, "no counter was printed", "The node ended by itself"),
    ({"[this] { timer": "[this](int) { timer"}, "does not compile", "The callback does not fit what calls it"),
    ({"counter_++;": "*std::shared_ptr<int>() = 1;"}, "it has used a null pointer", "was not made yet"),
    ({"counter_++;": "counter_ += 1 / counter_;"}, "stopped in line 19: `it has divided by zero`", "be divided by 0"),
    ({"counter_++;": 'throw std::runtime_error("lost");'}, "what(): lost", "nothing in the node has caught it"),
    ({"rclcpp/rclcpp.hpp": "ros/ros.h"}, "This node is for ROS 1", "This exercise is on ROS 2"),
]
