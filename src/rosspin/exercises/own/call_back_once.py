"""A timer stops when its callback returns early: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

TITLE = "Call back once"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md).

This node should do something **once**, 1.5 s after it starts, but its timer fires again and again. Stop that timer
after its first call, and keep the heartbeat. In ROS 2, `create_timer` has no `oneshot`.
"""
REVEALS = "A timer stops when its callback returns early. `rclpy.shutdown()` stops a timer."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.beats = 0
        self.create_timer(1.5, self.timer_callback)
        self.create_timer(1.0, self.heartbeat_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))

    def heartbeat_callback(self):
        self.beats += 1
        self.get_logger().info("[HEARTBEAT] counter = " + str(self.beats))


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
    timer_ = create_wall_timer(1500ms, [this] { timerCallback(); });
    heartbeat_ = create_wall_timer(1s, [this] { heartbeatCallback(); });
  }

private:
  void timerCallback()
  {
    counter_++;
    RCLCPP_INFO_STREAM(get_logger(), "[SPINNER CPP NODE] counter = " << counter_);
  }

  void heartbeatCallback()
  {
    beats_++;
    RCLCPP_INFO_STREAM(get_logger(), "[HEARTBEAT] counter = " << beats_);
  }

  unsigned int counter_ = 0;
  unsigned int beats_ = 0;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::TimerBase::SharedPtr heartbeat_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SpinnerCppNode>());
  return 0;
}
"""

HINTS = [
    "`create_timer` returns the timer. Keep it.",
    "A timer has a method `cancel()`.",
    "Call `self.timer.cancel()` in the callback.",
]
HINTS_CPP = [
    "Which variable holds the timer?",
    "A timer has a method `cancel()`.",
    "Call `timer_->cancel()` in the callback.",
]
_STOPS_ALL = "Stop one timer, and no more: what ends the node, or keeps its callback from returning, stops them all."
_FIRST = "The first call should come after 1.5 s, as before. Its timer is stopped then, and not earlier."
HINT = "Keep the timer in `self.timer`, and call its `cancel()` in the callback."
HINT_CPP = "Call the `cancel()` of the timer in its callback: `timer_->cancel()`."


check = by.run(
    6.0,
    by.ticks(at=[1.5], hint=lambda counters: by.unless_first_at(1.5, _FIRST if counters else _STOPS_ALL)(counters)),
    by.ticks(1.0, "The heartbeat", "HEARTBEAT", _STOPS_ALL),
    by.stops(1, "a timer of the node"),
)

SOLUTION = {
    "self.create_timer(1.5": "self.timer = self.create_timer(1.5",
    "    def timer_callback(self):\n": "    def timer_callback(self):\n        self.timer.cancel()\n",
}
AFTER = """
`self.timer.reset()` starts a cancelled timer again. `self.destroy_timer(self.timer)` removes it.
"""

SAYS = '        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))\n'
CANCELS = "        self.timer.cancel()\n"
KEEPS = "self.timer = self.create_timer(1.5, self.timer_callback)"
SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"

RIGHT = [
    {CANCELS + "        self.counter += 1\n" + SAYS: "        self.counter += 1\n" + SAYS + CANCELS},
    {CANCELS: "        self.destroy_timer(self.timer)\n"},
    {CANCELS: "        self.timer.destroy()\n"},
    # The heartbeat cancels it.
    {
        CANCELS: "",
        "        self.beats += 1\n": "        self.beats += 1\n        if self.beats == 2: self.timer.cancel()\n",
    },
    {KEEPS: "self.timer = self.create_timer(1.5, lambda: self.timer_callback())"},
    {KEEPS: "self.timer = self.create_timer(timer_period_sec=1.5, callback=self.timer_callback)"},
    {TRY: "    rclpy.spin(spinner_py_node)\n"},
    {TRY: "    while rclpy.ok():\n        rclpy.spin_once(spinner_py_node)\n"},
    {
        "import ExternalShutdownException": "import ExternalShutdownException, SingleThreadedExecutor",
        SPIN: "        executor = SingleThreadedExecutor()\n        executor.add_node(spinner_py_node)\n"
        "        executor.spin()\n",
    },
    {
        "import ExternalShutdownException": "import ExternalShutdownException, MultiThreadedExecutor",
        SPIN: "        executor = MultiThreadedExecutor()\n        executor.add_node(spinner_py_node)\n"
        "        executor.spin()\n",
    },
    {TRY: "    try:\n        rclpy.spin(spinner_py_node)\n    finally:\n        rclpy.shutdown()\n"},
]
WRONG = [
    ({"self.timer.cancel()": "self.timer.cancel"}, "counter 2 came at 3 s", "write `self.timer.cancel()`"),
    ({"(1.5": "(1.0"}, "counter 1 came at 1 s, not at 1.5 s", "The first call should come after 1.5 s"),
    ({CANCELS: "        del self.timer\n"}, "object has no attribute 'timer'", "before this line runs"),
    ({KEEPS: KEEPS.replace(")", ", autostart=False)")}, "no counter was printed", "or never started"),
    (
        {CANCELS: "        if self.counter:\n            return\n"},
        "the callback was called 4 times in 6 s",
        "A callback that returns immediately is still called",
    ),
    (
        {CANCELS: "        rclpy.shutdown()\n"},
        "The heartbeat: counter 2, due at 2 s",
        "Stop one timer, and no more",
    ),
    ({CANCELS: "        raise SystemExit\n"}, "The heartbeat: counter 2, due", "what ends the node"),
    (
        {
            SAYS: SAYS + "        while True:\n            time.sleep(1)\n",
            "import rclpy\n": "import time\n\nimport rclpy\n",
        },
        "The heartbeat: counter 2, due",
        "keeps its callback from returning",
    ),
    ({CANCELS: "        self.executor.shutdown()\n"}, "The heartbeat: counter 2, due", "Stop one timer"),
    (
        {"self.timer = ": "timer = "},
        "AttributeError: 'SpinnerPyNode' object has no attribute 'timer'",
        "`timer` is a variable of one function.",
    ),
    (
        {KEEPS: KEEPS.replace(")", ", oneshot=True)")},
        "unexpected keyword argument 'oneshot'",
        "In ROS 2 a timer has no `oneshot`.",
    ),
    ({CANCELS: "        self.timer.shutdown()\n"}, "has no attribute 'shutdown'", "A `Timer` has no `shutdown`."),
    ({"timer_callback(self)": "timer_callback(self, event)"}, "missing 1 required positional", "no argument"),
    ({KEEPS: KEEPS.replace("timer_callback)", "timer_callback())")}, "has no attribute 'timer'", "Python names"),
    ({SPIN: "        pass\n"}, "no counter was printed", "Does its main part come to `rclpy.spin(node)`?"),
    ({"    rclpy.init()\n": ""}, "NotInitialized", "Call rclpy.init() before"),
    (
        {
            CANCELS: "        threading.Timer(1.0, self.timer.cancel).start()\n        if self.counter: return\n",
            KEEPS: "self.timer = self.create_timer(0.5, self.timer_callback)",
            "import rclpy\n": "import threading\n\nimport rclpy\n",
        },
        "counter 1 came at 0.5 s, not at 1.5 s",
        "The first call should come after 1.5 s",
    ),
]

COUNTS_CPP = "    counter_++;\n"

SOLUTION_CPP = {COUNTS_CPP: f"    timer_->cancel();\n{COUNTS_CPP}"}

RIGHT_CPP = [
    {"timer_->cancel();": "timer_.reset();"},
    {"timer_->cancel();": "if (counter_ == 0)\n      timer_->cancel();"},
    {
        "[this] { timerCallback(); }": "[this](rclcpp::TimerBase& timer) { timerCallback(); timer.cancel(); }",
        "    timer_->cancel();\n": "",
    },
    {
        "create_wall_timer(1500ms, [this] { timerCallback(); })": "create_timer(1.5s, "
        "std::bind(&SpinnerCppNode::timerCallback, this))"
    },
]
WRONG_CPP = [
    (
        {"timer_->cancel();": "if (counter_ > 0)\n      return;"},
        "the callback was called 4 times in 6 s, where 1 would do",
        "Stop the timer itself.",
    ),
    (
        {"timer_->cancel();": ""},
        "counter 2 came at 3 s; it should not have come",
        "Call the `cancel()` of the timer in its callback:",
    ),
    (
        {"timer_->cancel();": "rclcpp::shutdown();"},
        "The heartbeat: counter 2, due at 2 s, did not come",
        "Stop one timer, and no more",
    ),
    (
        {"timer_->cancel();": "heartbeat_->cancel();"},
        "counter 2 came at 3 s",
        "Call the `cancel()` of the timer in its callback",
    ),
    (
        {"timer_->cancel();": "timer_->cancel();\n    heartbeat_->cancel();"},
        "The heartbeat: counter 2",
        "Stop one timer, and no more",
    ),
    (
        {COUNTS_CPP: COUNTS_CPP, "timer_->cancel();": "std::exit(0);"},
        "no counter was printed",
        "Stop one timer, and no more: what ends the node, or keeps its",
    ),
    (
        {"    timer_->cancel();\n": "", "    heartbeat_ = ": "    timer_->cancel();\n    heartbeat_ = "},
        "no counter was printed",
        "was stopped before its first call",
    ),
    (
        {"timer_->cancel();": "timer_->stop();"},
        "does not compile: `no member named 'stop'",
        "There is nothing of this name: compare its spelling",
    ),
    (
        {"timer_->cancel();": "timer_.cancel();"},
        "does not compile",
        "Nothing ran. Begin with the compiler's first error: others may",
    ),
    ({"1500ms": "500ms"}, "counter 1 came at 0.5 s, not at 1.5 s", "The first call should come after 1.5 s"),
    (
        {"timer_->cancel();": "while (rclcpp::ok() && counter_ > 0)\n      rclcpp::sleep_for(100ms);"},
        "counter 2 came at 6 s; it should not have come.",
        "Call the `cancel()` of the timer in its callback",
    ),
]
