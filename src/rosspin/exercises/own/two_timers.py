"""Two rates need two nodes: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..feedback import Finding
from ..judging import plain
from ..observed import ObservedRun

TITLE = "Give a node two timers"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md).

This node prints `[FAST] counter = 1` and so on, ten times a second. Add a second timer, which prints
`[SLOW] counter = 1` and so on, twice a second.
"""
REVEALS = "Two rates need two nodes."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        self.create_timer(0.1, self.fast_callback)

    def fast_callback(self):
        self.counter += 1
        self.get_logger().info("[FAST] counter = " + str(self.counter))


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
    fast_timer_ = create_wall_timer(100ms, [this] { fastCallback(); });
  }

private:
  void fastCallback()
  {
    counter_++;
    RCLCPP_INFO_STREAM(get_logger(), "[FAST] counter = " << counter_);
  }

  unsigned int counter_ = 0;
  rclcpp::TimerBase::SharedPtr fast_timer_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SpinnerCppNode>());
  return 0;
}
"""

HINTS = [
    "A node can have as many timers as it likes.",
    "Each timer has a period and a callback of its own.",
    "Does each of them have a counter of its own?",
]
HINTS_CPP = [*HINTS, "Does a member of the class keep the new timer? It ends with the last pointer to it."]
HINT = "A node can have as many timers as it likes, each with its own period, callback and counter."
HINT_CPP = HINT


def _have_timers_of_their_own(run: ObservedRun, when: str) -> Finding | None:
    """Whether the counters of each tag were printed by a timer of their own, and all these timers are of one node."""
    printed = {tag: run.counters(tag) for tag in ("FAST", "SLOW")}
    if not all(printed.values()):
        return None
    nodes: dict[str, str] = {}
    tag_of: dict[int, str] = {}  # by the number of a timer
    second = "The exercise asks for a timer of its own for each, with its own period, callback and counter."
    for tag, counters in printed.items():
        timers, others = run.printers(counters)
        if others:
            text = f"counter {plain(others[0].text)} of `[{tag}]` was not printed by the callback of a timer."
            return Finding(False, text, second)
        for timer in timers:
            if timer.number in tag_of:
                return Finding(False, f"one timer prints both `[{tag_of[timer.number]}]` and `[{tag}]`.", second)
            tag_of[timer.number] = nodes[timer.node] = tag
    if len(nodes) > 1:
        names = " and ".join(f"`{plain(name)}`" for name in nodes)
        return Finding(False, f"the timers are of two nodes, {names}.", "One node can have both timers.")
    return Finding(True, "each has a timer of its own, and both are of one node.")


check = by.run(
    2.0,
    by.ticks(0.1, "`[FAST]`", "FAST", by.unless_regular(0.1, "")),
    by.ticks(0.5, "`[SLOW]`", "SLOW", by.unless_regular(0.5, "")),
    _have_timers_of_their_own,
)

SOLUTION = {
    "        self.counter = 0\n": "        self.fast_counter = 0\n        self.slow_counter = 0\n",
    "        self.create_timer(0.1, self.fast_callback)\n": "        self.create_timer(0.1, "
    "self.fast_callback)\n        self.create_timer(0.5, self.slow_callback)\n",
    "        self.counter += 1\n"
    '        self.get_logger().info("[FAST] counter = " + str(self.counter))\n': "        self.fast_counter "
    "+= 1\n"
    '        self.get_logger().info("[FAST] counter = " + str(self.fast_counter))\n'
    "\n"
    "    def slow_callback(self):\n"
    "        self.slow_counter += 1\n"
    '        self.get_logger().info("[SLOW] counter = " + str(self.slow_counter))\n',
}

SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"
FAST = "self.create_timer(0.1, self.fast_callback)"
SLOW = "self.create_timer(0.5, self.slow_callback)"
AS_MANY = "as many timers as it likes"
EACH_FIFTH = {
    f"        {SLOW}\n": "",
    "str(self.fast_counter))\n": "str(self.fast_counter))\n        if self.fast_counter % 5 == 0:\n"
    "            self.slow_callback()\n",
}
TWO_NODES = """import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
class Counts(Node):
    def __init__(self, tag, period):
        super().__init__(tag.lower())
        self.tag, self.counter = tag, 0
        self.create_timer(period, self.count)
    def count(self):
        self.counter += 1
        self.get_logger().info(f"[{self.tag}] counter = {self.counter}")
rclpy.init()
executor = SingleThreadedExecutor()
nodes = [Counts("FAST", 0.1), Counts("SLOW", 0.5)]
for node in nodes:
    executor.add_node(node)
executor.spin()
"""
SLOW_THREAD = {
    f"        {SLOW}\n": "        threading.Thread(target=self.slow_loop, daemon=True).start()\n",
    "    def slow_callback(self):\n": "    def slow_loop(self):\n        while True:\n            time.sleep(0.5)\n"
    "            self.slow_callback()\n\n    def slow_callback(self):\n",
    "import rclpy\n": "import threading\nimport time\n\nimport rclpy\n",
}

RIGHT = [
    {SLOW: "self.create_timer(1 / 2, self.slow_callback)"},
    {FAST: f"self.fast = {FAST}", SLOW: f"self.slow = {SLOW}"},
    {SLOW: "self.create_timer(0.5, lambda: self.slow_callback())"},
    {TRY: "    rclpy.spin(spinner_py_node)\n"},
    {
        "import rclpy\n": "from itertools import count\n\nimport rclpy\n",
        "        self.fast_counter = 0\n": "        self.numbers = count(1)\n",
        "        self.fast_counter += 1\n": "",
        "str(self.fast_counter)": "str(next(self.numbers))",
    },
]
WRONG = [
    (
        {"        self.create_timer(0.5, self.slow_callback)": "        self.create_timer(0.5, self.fast_callback)"},
        "`[FAST]`: counter 6 came at 0.5 s, not at 0.6 s",
        "Of two methods with one name, the later one is called",
    ),
    (
        {
            f"        {SLOW}\n": "",
            "        self.fast_counter += 1\n": f"        {SLOW}\n        self.fast_counter += 1\n",
        },
        "node has 2",
        "Each call of a callback makes one more timer",
    ),
    ({SLOW: SLOW.replace("0.5", "0.4")}, "counter 1 came at 0.4 s, not at 0.5 s", "They come every 0.4 s"),
    (EACH_FIFTH, "one timer prints both `[FAST]` and `[SLOW]`", "a timer of its own for each"),
    (TWO_NODES, "the timers are of two nodes, `/fast` and `/slow`", "One node can have both"),
    (SLOW_THREAD, "counter 1 of `[SLOW]` was not printed by the callback of a timer", "a timer of its own"),
    (
        {"slow_counter": "fast_counter"},
        "`[SLOW]`: where counter 1 was due, counter 6 came",
        "Something else counts in the same variable, or prints the same words:",
    ),
    ({"(0.5,": "(2.0,"}, "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s", "They come every 2 s"),
    (
        {"(0.5,": "(5,"},
        "`[SLOW]`: no counter was printed",
        "A timer of the node has a period of 5 s, so its first call is not due",
    ),
    ({"(0.1,": "(0.5,"}, "`[FAST]`: counter 1 came at 0.5 s", "They come every 0.5 s"),
    (
        {"[SLOW]": "[slow]"},
        "`[SLOW]`: no counter was printed",
        "The lines should read `[SLOW] counter = 1` and so on.",
    ),
    (
        {"self.slow_callback)": "self.fast_callback)"},
        "`[SLOW]`: no counter was printed",
        "given a callback of its own?",
    ),
    ({"        self.slow_counter = 0\n": ""}, "has no attribute 'slow_counter'", "Python names"),
    ({f"        {SLOW}\n": ""}, "`[SLOW]`: no counter was printed", AS_MANY),
    (
        {
            "str(self.slow_counter))": "str(self.slow_counter))\n        time.sleep(0.6)",
            "import rclpy\n": "import time\n\nimport rclpy\n",
        },
        "`[FAST]`: counter 6 came at",
        "The callback sleeps, at line 23",
    ),
]

MADE_CPP = "    fast_timer_ = create_wall_timer(100ms, [this] { fastCallback(); });\n"
SLOW_CPP = "    slow_timer_ = create_wall_timer(500ms, [this] { slowCallback(); });\n"
SAYS_CPP = '    RCLCPP_INFO_STREAM(get_logger(), "[SLOW] counter = " << slow_counter_);\n'

SOLUTION_CPP = {
    MADE_CPP: MADE_CPP + SLOW_CPP,
    "  unsigned int counter_ = 0;\n": "  void slowCallback()\n  {\n    slow_counter_++;\n"
    f"{SAYS_CPP}  }}\n\n  unsigned int counter_ = 0;\n  unsigned int slow_counter_ = 0;\n",
    "fast_timer_;\n": "fast_timer_;\n  rclcpp::TimerBase::SharedPtr slow_timer_;\n",
}

RIGHT_CPP = [
    {"500ms": "std::chrono::duration<double>(1 / 2.0)"},
    {SLOW_CPP: "    slow_timer_ = create_timer(0.5s, std::bind(&SpinnerCppNode::slowCallback, this));\n"},
    {
        SLOW_CPP: "    slow_timer_ = rclcpp::create_wall_timer(500ms, [this] { slowCallback(); }, nullptr, "
        "get_node_base_interface().get(), get_node_timers_interface().get());\n"
    },
    {SAYS_CPP: '    RCLCPP_INFO(get_logger(), "[SLOW] counter = %u", slow_counter_);\n'},
    {
        SAYS_CPP: '    std::cout << "[SLOW] counter = " << slow_counter_ << std::endl;\n',
        "#include <memory>": "#include <iostream>\n#include <memory>",
    },
]
WRONG_CPP = [
    ({SLOW_CPP: ""}, "`[SLOW]`: no counter was printed", AS_MANY),
    (
        {
            SLOW_CPP: "",
            '"[FAST] counter = " << counter_);\n': '"[FAST] counter = " << counter_);\n'
            "    if (counter_ % 5 == 0)\n      slowCallback();\n",
        },
        "one timer prints both `[FAST]` and `[SLOW]`",
        "a timer of its own for each",
    ),
    (
        {"slow_counter_++": "counter_++", "slow_counter_);": "counter_);"},
        "`[SLOW]`: where counter 1 was due, counter 5 came",
        "Something else counts in the same variable, or prints the same words:",
    ),
    ({"500ms": "2s"}, "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s", "They come every 2 s"),
    ({"500ms": "5s"}, "`[SLOW]`: no counter was printed", "A timer of the node has a period of 5 s"),
    (
        {"    slow_timer_ =": "    auto slow_timer_ ="},
        "`[SLOW]`: no counter was printed",
        "was stopped before its first call",
    ),
    (
        {"    slow_timer_ =": "    fast_timer_ ="},
        "`[FAST]`: no counter was printed",
        "A timer of the node was stopped before its first call, or never",
    ),
    ({"[SLOW]": "[slow]"}, "`[SLOW]`: no counter was printed", "The lines should read `[SLOW] counter = 1` and so on."),
    (
        {"[this] { slowCallback(); }": "slowCallback"},
        "does not compile",
        "A member function is called on an object.",
    ),
    (
        {"  void slowCallback()": "  void slow()"},
        "does not compile: `use of undeclared identifier 'slowCallback'",
        "There is nothing of this name: compare its spelling",
    ),
    ({SAYS_CPP: SAYS_CPP + "    rclcpp::sleep_for(600ms);\n"}, "`[FAST]`: counter 5 came at", AS_MANY),
]
