"""A timer stops when its callback does nothing any more: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..odd_nodes import CAUGHT, HEAD, PLAIN, at, say

TITLE = "Fire once"
TEXT = """
**You need**: [the timer node](timer.md).

Make the timer call back once, 1.5 s after the start, and then stop. The node itself continues.
"""
REVEALS = "A timer stops when its callback does nothing any more."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        timer_delta_t_in_seconds = 0.5
        rospy.Timer(
            rospy.Duration(timer_delta_t_in_seconds), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))


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
    double timer_delta_t_in_seconds = 0.5;
    timer_ = nh_.createTimer(
        ros::Duration(timer_delta_t_in_seconds), &SpinnerCppNode::timerCallback, this);
  }

private:
  void timerCallback(const ros::TimerEvent&)
  {
    counter_++;
    ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter_);
  }

  ros::NodeHandle nh_;
  ros::Timer timer_;
  unsigned int counter_ = 0;
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
    "It is not enough that the callback does nothing: its timer still runs.",
    "`rospy.Timer` has a third parameter, `False` in the tutorial's timer node. What is it called?",
    "With `oneshot=True` there is one call, one period after the start.",
]
HINTS_CPP = [
    "It is not enough that the callback does nothing: its timer still runs.",
    "`createTimer` has more parameters than these three. What is the fourth called?",
    "With `true` as its fourth argument, `oneshot`, there is one call, one period after the start.",
]
HINT = "`rospy.Timer` has a parameter `oneshot`; its period is then the time until the only call."
HINT_CPP = "`createTimer` has a parameter `oneshot`; its period is then the time until the only call."

check = by.run(5.0, by.ticks(at=[1.5]), by.stops(1))

SOLUTION = {"0.5": "1.5", " self.timerCallback)": "\n            self.timerCallback, oneshot=True)"}


RIGHT = [
    {", oneshot=True": ", True"},
    *at("1.5", PLAIN.replace("callback)", "callback, oneshot=True)")),
    *at("1.5", CAUGHT.replace("callback=Spinner()", "callback=Spinner(), oneshot=True")),
    *at("1.5", PLAIN.replace(f"    {say('count')}", f"    {say('count')}\n    timer.shutdown()")),
    *at("1.5", PLAIN.replace("rospy.spin()", "rospy.sleep(2)\ntimer.shutdown()\nrospy.spin()")),
    *at(
        "1.5",
        PLAIN.replace("rospy.spin()", "while not count:\n    rospy.sleep(0.1)\ntimer.shutdown()\nrospy.spin()"),
    ),
    {"self.timerCallback, oneshot": "lambda event: self.timerCallback(event), oneshot"},
]
WRONG = [
    ({", oneshot=True": ""}, "counter 2 came at 3 s; it should not have come", "has a parameter `oneshot`"),
    ({"rospy.spin()": "rospy.sleep(2)"}, "the node ended by itself", "Does its main part come to `rospy.spin()`?"),
    (
        {"str(self.counter))": 'str(self.counter))\n        rospy.signal_shutdown("done")'},
        "the node ended by itself",
        "before its time was over",
    ),
    ({"= 1.5": "= 0.5"}, "counter 1 came at 0.5 s, not at 1.5 s", "the time until the only call"),
    ({"oneshot=True": "oneshot"}, "stopped in line 10: `NameError: name 'oneshot'", "Python names what"),
    (
        {
            ", oneshot=True": "",
            "        self.counter += 1\n": "        if self.counter: return\n        self.counter += 1\n",
        },
        "the callback was called 3 times in 5 s, where 1 would do",
        "Stop the timer itself",
    ),
    (
        {", oneshot=True": "", "str(self.counter))": "str(self.counter))\n        rospy.sleep(1e6)"},
        "a call of its callback had not returned",
        "A callback that never returns keeps its thread",
    ),
    (
        {", oneshot=True": "", "str(self.counter))": "str(self.counter))\n        raise SystemExit"},
        "its thread was ended",
        "ends the thread that the callback runs in",
    ),
    (
        {"str(self.counter))": "str(self.counter))\n        rospy.spin()"},
        "a call of its callback had not returned",
        "never returns",
    ),
    (
        f"{HEAD}rospy.sleep(1.5)\n{say('1')}\nrospy.spin()",
        "not printed by the callback of a `rospy.Timer`",
        "Use a timer",
    ),
    (
        {"str(self.counter))": "str(self.counter))\n        1 / 0"},
        "in line 15: `ZeroDivisionError",
        "This line divides by 0.",
    ),
    (
        f"import threading\n{HEAD}threading.Timer(1.5, lambda: {say('1')}).start()\nrospy.spin()",
        "not printed by the callback of a `rospy.Timer`",
        "Use a timer",
    ),
]

SOLUTION_CPP = {"0.5": "1.5", ", this);": ", this, true);"}

RIGHT_CPP = [
    {", this, true);": ", this);", "    counter_++;\n": "    timer_.stop();\n    counter_++;\n"},
    {", this, true);": ", this);", "    counter_++;\n": "    counter_++;\n    timer_ = ros::Timer();\n"},
    {"1.5": "3 / 2.0"},
    {", this, true);": ", this, true, false);\n    timer_.start();"},
]
WRONG_CPP = [
    (
        {", this, true);": ", this);"},
        "counter 2 came at 3 s; it should not have come",
        "`createTimer` has a parameter `oneshot`; its period is then the",
    ),
    (
        {", this, true);": ", this);", "    counter_++;\n": "    if (counter_ > 0)\n      return;\n    counter_++;\n"},
        "the callback was called 3 times in 5 s, where 1 would do",
        "A callback that returns immediately is still called. Stop the",
    ),
    (
        {"1.5": "0.5"},
        "counter 1 came at 0.5 s, not at 1.5 s",
        "`createTimer` has a parameter `oneshot`; its period is then the",
    ),
    (
        {", this, true);": ", this, true, false);"},
        "no counter was printed",
        "What should call the callback?",
    ),
    (
        {", this, true);": ", this, oneshot=true);"},
        "does not compile",
        "There is nothing of this name: compare its spelling",
    ),
    (
        {
            ", this, true);": ", this);",
            "    counter_++;\n": "    counter_++;\n    timer_.setPeriod(ros::Duration(100));\n",
        },
        "the timer still runs",
        "Stop the timer itself",
    ),
    ({"timer_ = nh_": "ros::Timer timer = nh_"}, "no counter was printed", "was stopped before its first call"),
]
