"""What a lambda has captured stays there as long as the lambda does: a belief that this reveals."""

from __future__ import annotations

from collections.abc import Iterator

from .. import judges as by
from ..feedback import Finding
from ..judging import Answer
from ..observed import ObservedRun

TITLE = "A lambda that outlives its node"
TEXT = """
**You need**: [the timer node in ROS 2](ros2-timer.md), in C++.

This program should count twice a second, from 1 on. It compiles, but what it prints is no counter. Repair it, so that
the counter stays in the class.
"""
REVEALS = "What a lambda has captured lives as long as the lambda."

NODE = """
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

class SpinnerCppNode
{
public:
  explicit SpinnerCppNode(rclcpp::Node::SharedPtr node) : node_(node)
  {
    timer_ = node_->create_wall_timer(500ms, [this] { timerCallback(); });
  }

  rclcpp::TimerBase::SharedPtr timer_;

private:
  void timerCallback()
  {
    counter_++;
    RCLCPP_INFO_STREAM(rclcpp::get_logger("spinner_cpp_node"), "[SPINNER CPP NODE] counter = " << counter_);
  }

  rclcpp::Node::SharedPtr node_;
  unsigned int counter_ = 0;
};

rclcpp::TimerBase::SharedPtr start(rclcpp::Node::SharedPtr node)
{
  auto spinner_cpp_node = std::make_unique<SpinnerCppNode>(node);
  return spinner_cpp_node->timer_;
}

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("spinner_cpp_node");
  auto timer = start(node);
  rclcpp::spin(node);
  return 0;
}
"""

HINTS = [
    "The lambda captures `this`, a pointer to an object. How long does that object live, and how long the lambda?",
    "The object ends with `start`, as `spinner_cpp_node` is a variable of that function. The timer, and the lambda in "
    "it, live longer.",
    "Let `main` keep the object for as long as it spins: `start` can return it, with the timer in it.",
]
HINT = "The lambda is called after the object is gone whose `this` it has captured. Who could keep that object?"


# A counter that begins with more than this is none: nothing counts so far in a run.
_MOST = 1000


def _no_counter(run: ObservedRun) -> Finding | None:
    """Whether what is printed comes from memory that is something else's now."""
    found = run.counters()
    number = by.as_whole(found[0].text) if found else None
    if number is None or number <= _MOST:
        return None
    text = f"where counter 1 was due, counter {number} came: what is printed is no counter."
    return Finding(False, text, "Where the counter was, there is something else now. " + HINT)


_KEPT = "The timer has to be kept as well: it ends with the last pointer to it."


def check(answer: Answer) -> Iterator[Finding]:
    """Check what it prints first: a program that counts in something else's memory may end in any way."""
    if finding := _no_counter(answer.run(3.0, allowed="used memory")):
        yield finding
    else:
        yield from by.run(3.0, by.ticks(0.5, hint=_KEPT))(answer)


SOLUTION = {
    "rclcpp::TimerBase::SharedPtr start(": "std::unique_ptr<SpinnerCppNode> start(",
    "  auto spinner_cpp_node = std::make_unique<SpinnerCppNode>(node);\n"
    "  return spinner_cpp_node->timer_;\n": "  return std::make_unique<SpinnerCppNode>(node);\n",
    "auto timer = start": "auto spinner_cpp_node = start",
}

STARTS = "auto spinner_cpp_node = start(node);"
RETURNS = "std::unique_ptr<SpinnerCppNode> start("
MAKES = "  return std::make_unique<SpinnerCppNode>(node);\n"
KEPT_BY_TIMER = {  # who keeps the timer keeps the object
    RETURNS: "rclcpp::TimerBase::SharedPtr start(",
    MAKES: "  auto spinner = std::make_shared<SpinnerCppNode>(node);\n"
    "  return rclcpp::TimerBase::SharedPtr(spinner, spinner->timer_.get());\n",
}
BEGINS = "    timer_ = node_->create_wall_timer(500ms, [this] { timerCallback(); });\n"

RIGHT = [
    {"unique": "shared"},
    {STARTS: "SpinnerCppNode spinner_cpp_node(node);"},
    {STARTS: "static SpinnerCppNode spinner_cpp_node(node);"},
    KEPT_BY_TIMER,
    {MAKES: "  auto made = std::make_unique<SpinnerCppNode>(node);\n  return made;\n"},
    {RETURNS: "auto start("},
    {"[this] { timer": "[spinner = this] { spinner->timer"},
]
WRONG = [
    (
        {
            RETURNS: "rclcpp::TimerBase::SharedPtr start(",
            MAKES: "  SpinnerCppNode made(node);\n  return made.timer_;\n",
        },
        "what is printed is no counter",
        "Where the counter was, there is something else now.",
    ),
    (
        {RETURNS: "auto start(", MAKES: MAKES.replace(";", "->timer_;")},
        "what is printed is no counter",
        "Who could keep",
    ),
    ({STARTS: "start(node);"}, "no counter was printed", "was stopped before its first call"),
    ({STARTS: "auto timer = start(node)->timer_;"}, "what is printed is no counter", "Who could keep that object?"),
    (
        {STARTS: "auto* spinner_cpp_node = start(node).get();\n  (void)spinner_cpp_node;"},
        "no counter was printed",
        "was stopped before its first call",
    ),
    ({"[this] {": "[] {"}, "does not compile: `'this' cannot be implicitly captured", "write [this] in place of []"),
    ({"500ms": "200ms"}, "counter 1 came at 0.2 s, not at 0.5 s", "The timer has to be kept"),
    ({"    counter_++;\n": ""}, "where counter 1 was due, counter 0 came", "The counter stays at 0"),
    (
        {STARTS: f"{STARTS}\n  spinner_cpp_node.reset();"},
        "no counter was printed",
        "was stopped before its first call",
    ),
]
