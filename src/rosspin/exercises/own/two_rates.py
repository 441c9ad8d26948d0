"""Two timers need two nodes: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..odd_nodes import HEAD, say

TITLE = "Run at two rates"
TEXT = """
**You need**: [the timer node](timer.md) and [Choose Timer or Rate](../docs/how-to/timer-or-rate.rst).

Make this node print `[FAST] counter = 1` and so on ten times a second, and `[SLOW] counter = 1` and so on twice a
second, each beginning one period after the start.
"""
REVEALS = "Two timers need two nodes. Two loops can follow each other."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.counter = 0
        rospy.Timer(rospy.Duration(0.1), self.fastCallback)

    def fastCallback(self, event):
        self.counter += 1
        rospy.loginfo("[FAST] counter = " + str(self.counter))


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
    fast_timer_ = nh_.createTimer(ros::Duration(0.1), &SpinnerCppNode::fastCallback, this);
  }

private:
  void fastCallback(const ros::TimerEvent&)
  {
    counter_++;
    ROS_INFO_STREAM("[FAST] counter = " << counter_);
  }

  ros::NodeHandle nh_;
  ros::Timer fast_timer_;
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
    "A node can have as many timers as it likes.",
    "Each has a period and a callback of its own.",
    "And a counter of its own?",
]
HINTS_CPP = [*HINTS, "Does a member of the class keep the new timer? It ends with the last `ros::Timer` for it."]
HINT = "A node can have as many timers as it likes, each with its own period, callback and counter."
HINT_CPP = HINT

check = by.run(2.0, by.ticks(0.1, "`[FAST]`", "FAST"), by.ticks(0.5, "`[SLOW]`", "SLOW"))

SOLUTION = {
    "        self.counter = 0\n": "        self.fast_counter = 0\n        self.slow_counter = 0\n",
    "        rospy.Timer(rospy.Duration(0.1), self.fastCallback)\n": (
        "        rospy.Timer(rospy.Duration(0.1), self.fastCallback)\n"
        "        rospy.Timer(rospy.Duration(0.5), self.slowCallback)\n"
    ),
    '        self.counter += 1\n        rospy.loginfo("[FAST] counter = " + str(self.counter))\n': (
        "        self.fast_counter += 1\n"
        '        rospy.loginfo("[FAST] counter = " + str(self.fast_counter))\n'
        "\n"
        "    def slowCallback(self, event):\n"
        "        self.slow_counter += 1\n"
        '        rospy.loginfo("[SLOW] counter = " + str(self.slow_counter))\n'
    ),
}

TWO_RATES_LOOP = f"""{HEAD}fast = 0
def callback(event):
    global fast
    fast += 1
    {say("fast", "FAST")}
rospy.Timer(rospy.Duration(0.1), callback)
slow = 0
SLOW
"""
SLOW_LOOP = f"""rate = rospy.Rate(2)
while not rospy.is_shutdown():
    rate.sleep()
    slow += 1
    {say("slow", "SLOW")}"""

RIGHT = [
    TWO_RATES_LOOP.replace("SLOW\n", SLOW_LOOP + "\n", 1).replace("0\nSLOW", "0\n" + SLOW_LOOP),
    TWO_RATES_LOOP.replace(
        "\nSLOW\n",
        "\nwhile True:\n    rospy.sleep(0.5)\n    if rospy.is_shutdown(): break\n"
        f"    slow += 1\n    {say('slow', 'SLOW')}\n",
    ),
    TWO_RATES_LOOP.replace("\nSLOW\n", "\nrospy.spin()\n").replace(
        say("fast", "FAST"), f"{say('fast', 'FAST')}\n    if fast % 5 == 0: {say('fast // 5', 'SLOW')}"
    ),
    f"""{HEAD}rate = rospy.Rate(10)
passes = 0
while not rospy.is_shutdown():
    rate.sleep()
    passes += 1
    {say("passes", "FAST")}
    if passes % 5 == 0:
        {say("passes // 5", "SLOW")}
""",
    f"""{HEAD}from functools import partial
from itertools import count
def call(tag, counts, event):
    rospy.loginfo("[%s] counter = %d", tag, next(counts))
for tag, period in ("FAST", 0.1), ("SLOW", 0.5):
    rospy.Timer(rospy.Duration(period), partial(call, tag, count(1)))
rospy.spin()
""",
    f"""import threading
{HEAD}def run(tag, hz):
    rate = rospy.Rate(hz)
    for number in range(1, 1000):
        rate.sleep()
        rospy.loginfo("[%s] counter = %d", tag, number)
threading.Thread(target=run, args=("FAST", 10), daemon=True).start()
threading.Thread(target=run, args=("SLOW", 2), daemon=True).start()
rospy.spin()
""",
]
WRONG = [
    ({"slow_counter": "fast_counter"}, "where counter 5 was due, counter 6 came", "a counter of its own"),
    ({"Duration(0.5)": "Duration(2)"}, "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s", "as many timers"),
    (
        {"Duration(0.1)": "Duration(0.5)", "Duration(0.5), self.slow": "Duration(0.1), self.slow"},
        "`[FAST]`: counter 1 came at 0.5 s",
        "as many timers",
    ),
    (
        TWO_RATES_LOOP.replace("\nSLOW\n", "\n" + SLOW_LOOP.replace("    rate.sleep()\n", "") + "\n    rate.sleep()\n"),
        "`[SLOW]`: counter 1 came at 0 s",
        "They come every 0.5 s, as asked for, but from the start.",
    ),
    (
        f"{HEAD}fast = slow = 0\nrate = rospy.Rate(10)\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
        f"    fast += 1\n    {say('fast', 'FAST')}\n" + SLOW_LOOP,
        "`[SLOW]`: no counter was printed",
        "as many timers",
    ),
    (
        {"[SLOW]": "[slow]"},
        "`[SLOW]`: no counter was printed",
        "The lines should read `[SLOW] counter = 1` and so on.",
    ),
    (
        {"self.slowCallback)": "self.fastCallback)"},
        "`[SLOW]`: no counter was printed",
        "given a callback of its own?",
    ),
    ({"        self.slow_counter = 0\n": ""}, "has no attribute 'slow_counter'", "Python names"),
    (
        {"str(self.slow_counter))": "str(self.slow_counter))\n        rospy.sleep(0.6)"},
        "`[SLOW]`: counter 2 came at 1.1 s",
        "The callback sleeps, at line 18",
    ),
]

MADE_CPP = "    fast_timer_ = nh_.createTimer(ros::Duration(0.1), &SpinnerCppNode::fastCallback, this);\n"
SLOW_CPP = "    slow_timer_ = nh_.createTimer(ros::Duration(0.5), &SpinnerCppNode::slowCallback, this);\n"
SAYS_CPP = '    ROS_INFO_STREAM("[SLOW] counter = " << slow_counter_);\n'

SOLUTION_CPP = {
    MADE_CPP: MADE_CPP + SLOW_CPP,
    "  ros::NodeHandle nh_;\n": "  void slowCallback(const ros::TimerEvent&)\n  {\n    slow_counter_++;\n"
    f"{SAYS_CPP}  }}\n\n  ros::NodeHandle nh_;\n",
    "fast_timer_;\n": "fast_timer_;\n  ros::Timer slow_timer_;\n",
    "counter_ = 0;\n": "counter_ = 0;\n  unsigned int slow_counter_ = 0;\n",
}

RIGHT_CPP = [
    {"Duration(0.5)": "Duration(1 / 2.0)"},
    {"createTimer(ros::Duration(0.5)": "createTimer(ros::Rate(2)"},
    {
        "createTimer(ros::Duration(0.5)": "createSteadyTimer(ros::WallDuration(0.5)",
        "slowCallback(const ros::TimerEvent&)": "slowCallback(const ros::SteadyTimerEvent&)",
        "ros::Timer slow": "ros::SteadyTimer slow",
    },
    {SAYS_CPP: '    ROS_INFO("[SLOW] counter = %u", slow_counter_);\n'},
]
WRONG_CPP = [
    (
        {SLOW_CPP: ""},
        "`[SLOW]`: no counter was printed",
        "A node can have as many timers as it likes, each with its own",
    ),
    (
        {"    slow_timer_ =": "    ros::Timer slow_timer_ ="},
        "`[SLOW]`: no counter was printed",
        "was stopped before its first call",
    ),
    (
        {"slow_counter_++": "counter_++", "slow_counter_);": "counter_);"},
        "`[SLOW]`: where counter 1 was due",
        "or prints the same words: give each timer a",
    ),
    (
        {"Duration(0.5)": "Duration(2.0)"},
        "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s",
        "A node can have as many timers as it likes, each with its own",
    ),
    (
        {"Duration(0.1)": "Duration(0.5)"},
        "`[FAST]`: counter 1 came at 0.5 s",
        "A node can have as many timers as it likes, each with its own",
    ),
    (
        {"&SpinnerCppNode::slowCallback": "slowCallback"},
        "does not compile",
        "A member function is called on an object.",
    ),
    (
        {SAYS_CPP: SAYS_CPP + "    ros::Duration(0.6).sleep();\n"},
        "`[FAST]`: counter 6 came at",
        "A node can have as many timers as it likes, each with its own",
    ),
    ({"[SLOW]": "[slow]"}, "`[SLOW]`: no counter was printed", "The lines should read `[SLOW] counter = 1` and so on."),
]
