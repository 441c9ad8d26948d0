"""A timer is given a frequency: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..odd_nodes import CAUGHT, LAMBDA, PLAIN, SLEEPS_FIRST, THREAD, at

TITLE = "Change the rate"
TEXT = """
**You need**: [the timer node](timer.md).

Make this timer node count ten times a second.
"""
REVEALS = "A timer is given a frequency."

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
    "Which line says how often the callback is called?",
    "A timer is given a period, in seconds. What is the period of 10 Hz?",
    "The period is 1 / frequency.",
]
HINTS_CPP = HINTS
HINT = "Ten times a second is once in 1 / 10 s: a timer takes a period, in seconds, and the period is 1 / frequency."
HINT_CPP = HINT

check = by.run(1.0, by.ticks(0.1))

SOLUTION = {"0.5": "0.1"}

NOT_A_FREQUENCY = "the period is 1 / frequency"

RIGHT = [
    {"= 0.1": "= 1 / 10"},
    {"rospy.Duration(timer_delta_t_in_seconds)": "rospy.Duration(0, 100000000)"},
    *at("0.1", PLAIN, LAMBDA, CAUGHT, SLEEPS_FIRST, THREAD),
]
LOOPS = (
    "        while not rospy.is_shutdown():\n            self.count()\n            rospy.sleep(0.1)\n\n"
    "    def count(self):\n"
)
WRONG = [
    (
        {"    def timerCallback(self, event):\n": f"    def timerCallback(self, event):\n{LOOPS}"},
        "one call of a timer's callback printed counters 1 to 10",
        by.RETURNS,
    ),
    ({"loginfo": "logdebug"}, "no counter was printed", "but that printed nothing"),
    ({"= 0.1": "= 10"}, "no counter was printed", NOT_A_FREQUENCY),
    ({"= 0.1": "= 0.01"}, "counter 1 came at 0.01 s, not at 0.1 s", NOT_A_FREQUENCY),
    ({"= 0.1": "= 1"}, "counter 1 came at 1 s, not at 0.1 s", NOT_A_FREQUENCY),
    ({"= 0.1": "= 1 // 10"}, "timer stopped with `ZeroDivisionError: division by zero`", "a period of 0 s"),
    ({"rospy.Duration(timer_delta_t_in_seconds)": "0.1"}, "has no attribute 'to_sec'", "is a Duration"),
    ({"+= 1": "+= 10"}, "where counter 1 was due, counter 10 came", "The counter goes up by 10 each time:"),
    ({"= 0.1": "= -0.1"}, "simulated time stands still", "runs without ever sleeping"),
    ({"    rospy.spin()": ""}, "counter 2, due at 0.2 s, did not come", "The node ended by itself"),
    ({"+ str(self.counter))": "+ str(self.counter)); self.timerCallback(event)"}, "RecursionError", "period"),
    (
        {"self.timerCallback)": "self.timerCallback, rate=10)"},
        "unexpected keyword argument 'rate'",
        "`rospy.Timer(rospy.Duration(0.5), self.callback)`:",
    ),
]

SOLUTION_CPP = {"0.5": "0.1"}

RIGHT_CPP = [
    {"0.1": "1 / 10.0"},
    {
        "timer_ = nh_.createTimer(": "timer_ = nh_.createTimer(ros::Rate(10), "
        "&SpinnerCppNode::timerCallback, this);\n    (void)(",
        "&SpinnerCppNode::timerCallback, this);\n  }": "this);\n  }",
    },
    {
        'ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter_)': 'ROS_INFO("[SPINNER CPP NODE] '
        'counter = %u", counter_)'
    },
    {"&SpinnerCppNode::timerCallback, this": "[this](const ros::TimerEvent& event) { timerCallback(event); }"},
    {"ros::Duration(timer_delta_t_in_seconds)": "ros::Duration(0, 100000000)"},
]
WRONG_CPP = [
    ({"0.1": "10.0"}, "no counter was printed", NOT_A_FREQUENCY),
    ({"0.1": "0.5"}, "counter 1 came at 0.5 s, not at 0.1 s", NOT_A_FREQUENCY),
    (
        {"0.1": "1 / 10"},
        "The node has a timer whose period is 0 s: it is called without",
        "In C++, `1 / 10` is 0, as both are whole numbers, and `1 /",
    ),
    ({"timer_ = nh_": "ros::Timer timer = nh_"}, "no counter was printed", "was stopped before its first call"),
    ({"const ros::TimerEvent&": ""}, "does not compile", "The callback does not fit"),
    ({"counter_++;": "counter_++"}, "does not compile: `expected ';'", "A ; is missing"),
    ({"  ros::spin();\n": ""}, "no counter was printed", "Does its main part come to `ros::spin()`"),
    (
        {"counter_++;": "counter_ += 2;"},
        "where counter 1 was due, counter 2 came",
        "The counter goes up by 2 each time: add 1 in each call. If",
    ),
    (
        {"[SPINNER CPP NODE]": "[SPINNER]"},
        "no counter was printed",
        "The lines should read `[SPINNER CPP NODE] counter = 1`",
    ),
    (
        {", this);": ", this, true);"},
        "counter 2, due at 0.2 s, did not come",
        "It came once, and never again: what should call back the next",
    ),
]
