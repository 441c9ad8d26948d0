"""A timer stops if its callback, its thread or the node ends: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..odd_nodes import say

TITLE = "Stop after five ticks"
TEXT = """
**You need**: [the timer node](timer.md).

One of this node's timers counts, the other is its heartbeat. Stop the first after counter 5.
"""
REVEALS = "A timer stops if its callback, its thread or the node ends."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        self.beats = 0
        rospy.Timer(rospy.Duration(0.5), self.timerCallback)
        rospy.Timer(rospy.Duration(1.0), self.heartbeat)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))

    def heartbeat(self, event):
        self.beats += 1
        rospy.loginfo("[HEARTBEAT] counter = " + str(self.beats))


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
"""

NODE_CPP = """
#include "ros/ros.h"

class SpinnerCppNode
{
public:
  SpinnerCppNode()
  {
    timer_ = nh_.createTimer(ros::Duration(0.5), &SpinnerCppNode::timerCallback, this);
    heartbeat_ = nh_.createTimer(ros::Duration(1.0), &SpinnerCppNode::heartbeatCallback, this);
  }

private:
  void timerCallback(const ros::TimerEvent&)
  {
    counter_++;
    ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter_);
  }

  void heartbeatCallback(const ros::TimerEvent&)
  {
    beats_++;
    ROS_INFO_STREAM("[HEARTBEAT] counter = " << beats_);
  }

  ros::NodeHandle nh_;
  ros::Timer timer_;
  ros::Timer heartbeat_;
  unsigned int counter_ = 0;
  unsigned int beats_ = 0;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "spinner_cpp_node");
  SpinnerCppNode spinner_cpp_node;
  ros::spin();
  return 0;
}
"""

HINTS = [
    "Returning early from the callback does not stop the timer.",
    "`rospy.Timer(...)` returns the timer. Keep it.",
    "A timer has a `shutdown()`, which its callback may call.",
]
HINTS_CPP = [
    "Returning early from the callback does not stop the timer.",
    "Which variable holds the timer?",
    "A timer has a `stop()`, which its callback may call.",
]
HINT = "Keep the timer in `self.timer`, and call its `shutdown()` after counter 5."
HINT_CPP = "Call `timer_.stop()` after counter 5."

_ENDS_ALL = "Stop one timer, and no more: what shuts the node down stops them all."

check = by.run(6.0, by.ticks(0.5, until=2.5), by.ticks(1.0, "The heartbeat", "HEARTBEAT", _ENDS_ALL), by.stops(5))

SOLUTION = {
    "rospy.Timer(rospy.Duration(0.5)": "self.timer = rospy.Timer(rospy.Duration(0.5)",
    "str(self.counter))\n": "str(self.counter))\n        if self.counter == 5:\n            self.timer.shutdown()\n",
}

HEART = f"""
beats = 0
def heartbeat(event):
    global beats
    beats += 1
    {say("beats", "HEARTBEAT")}
rospy.Timer(rospy.Duration(1), heartbeat)
"""


def counts(body: str, rest: str = "rospy.spin()\n") -> str:
    """A node around what its counting callback does."""
    callback = "\n".join(f"    {line}" for line in body.splitlines())
    head = "import sys, threading, rospy\nrospy.init_node('n')\ncount = 0\ndef callback(event):\n    global count\n"
    return f"{head}{callback}\n{HEART}timer = rospy.Timer(rospy.Duration(0.5), callback)\n{rest}"


COUNT = f"count += 1\n{say('count')}\n"

RIGHT = [
    counts(COUNT + "if count >= 5:\n    timer.shutdown()"),
    counts(COUNT, "rospy.sleep(2.75)\ntimer.shutdown()\nrospy.spin()\n"),
    counts(COUNT).replace("    beats += 1", "    beats += 1\n    if count == 5: timer.shutdown()"),
    counts(COUNT, "while count < 5:\n    rospy.sleep(0.1)\ntimer.shutdown()\nrospy.spin()\n"),
    counts(
        COUNT,
        "rate = rospy.Rate(20)\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
        "    if count == 5: timer.shutdown()\n",
    ),
    counts(COUNT, "threading.Timer(2.6, timer.shutdown).start()\nrospy.spin()\n"),
    counts(COUNT, "rospy.Timer(rospy.Duration(2.7), lambda e: timer.shutdown(), oneshot=True)\nrospy.spin()\n"),
    counts("rospy.loginfo('Traceback (most recent call last):')\n" + COUNT + "if count == 5: timer.shutdown()"),
]
WRONG = [
    ({"== 5": "> 5"}, "counter 6 came at 3 s; it should not have come", "call its `shutdown()`"),
    ({"self.timer.shutdown()": "rospy.signal_shutdown('five')"}, "The heartbeat: counter", "stops them all"),
    (counts("if count == 5: return\n" + COUNT), "the callback was called 12 times in 6 s", "Stop the timer itself"),
    (counts(COUNT + "if count == 5: sys.exit()"), "its thread was ended", "ends the thread that the callback"),
    (counts(COUNT + "if count == 5: rospy.sleep(1e6)"), "had not returned in the end", "never returns"),
    (counts(COUNT + "if count == 5: threading.Event().wait()"), "had not returned in the end", "never returns"),
    (
        {"self.timer.shutdown()": "self.timer.stop()"},
        "'Timer' object has no attribute 'stop'",
        "A `Timer` has no `stop`.",
    ),
    (
        counts(COUNT + "if count == 5: raise RuntimeError('stop')"),
        "timer stopped in line 8: `RuntimeError: stop`",
        "shutdown()",
    ),
    ({"self.timer = rospy": "rospy"}, "has no attribute 'timer'", "with its `self.`"),
    (
        counts("pass", f"for count in range(1, 6):\n    rospy.sleep(0.5)\n    {say('count')}\nrospy.spin()\n"),
        "not printed by the callback of a `rospy.Timer`",
        "Use a timer, and stop it",
    ),
    (
        counts(COUNT + "if count == 5:\n    while True: rospy.sleep(1)"),
        "had not returned in the end",
        "never returns",
    ),
    ({"rospy.Timer(rospy.Duration(1.0), self.heartbeat)": "pass"}, "The heartbeat: no counter", "Stop one timer"),
]

SAYS_CPP = '    ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter_);\n'
STOPS_CPP = "    if (counter_ == 5)\n      timer_.stop();\n"

SOLUTION_CPP = {SAYS_CPP: SAYS_CPP + STOPS_CPP}

RIGHT_CPP = [
    {SAYS_CPP: "", STOPS_CPP: STOPS_CPP + SAYS_CPP},
    {"timer_.stop();": "timer_ = ros::Timer();"},
    {"counter_ == 5": "counter_ >= 5"},
    {STOPS_CPP: "", "    counter_++;\n": f"    counter_++;\n{STOPS_CPP}"},
]
WRONG_CPP = [
    ({STOPS_CPP: ""}, "counter 6 came at 3 s; it should not have come", "Call `timer_.stop()` after counter 5."),
    (
        {STOPS_CPP: "", "    counter_++;\n": "    if (counter_ == 5)\n      return;\n    counter_++;\n"},
        "the callback was called 12 times in 6 s, where 5 would do",
        "A callback that returns immediately is still called. Stop the",
    ),
    (
        {"counter_ == 5": "counter_ == 4"},
        "counter 5, due at 2.5 s, did not come",
        "Call `timer_.stop()` after counter 5.",
    ),
    (
        {"timer_.stop();": "ros::shutdown();"},
        "The heartbeat: counter 3",
        "Stop one timer, and no more: what shuts the node down stops",
    ),
    (
        {"timer_.stop();": "heartbeat_.stop();"},
        "counter 6 came at 3 s",
        "Call `timer_.stop()` after counter 5",
    ),
    (
        {"timer_.stop();": "timer_.shutdown();"},
        "does not compile: `no member named 'shutdown'",
        "There is nothing of this name: compare its spelling",
    ),
    (
        {"timer_.stop();": "{ timer_.stop(); heartbeat_.stop(); }"},
        "The heartbeat: counter 3",
        "Stop one timer, and no more: what shuts the node down stops",
    ),
]
