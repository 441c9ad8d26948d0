"""roscpp and rospy time their timers alike: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "The ticks of a C++ node"
TEXT = """
**You need**: the [tutorial](../docs/tutorial.rst), and the rule for roscpp in [How timing works in ROS
1](../docs/how-timing-works.rst).

This is the same node in C++. `nh_.param` reads a parameter, with a default; `createTimer` is given the period, the
method to call, and its object.

```cpp
#include "ros/ros.h"

class SpinnerCppNode
{
public:
  SpinnerCppNode() : nh_("~"), counter_(0)
  {
    nh_.param("blocks_for", blocks_for_, 0.6);
    timer_ = nh_.createTimer(
        ros::Duration(0.4), &SpinnerCppNode::timerCallback, this);
  }

private:
  void timerCallback(const ros::TimerEvent&)
  {
    counter_++;
    ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter_);
    if (counter_ == 3)
      ros::Duration(blocks_for_).sleep();
  }

  ros::NodeHandle nh_;
  ros::Timer timer_;
  double blocks_for_;
  int counter_;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "spinner_cpp_node");
  SpinnerCppNode spinner_cpp_node;
  ros::spin();
  return 0;
}
```

When do callbacks 4, 5 and 6 come if the third one blocks for 0.6 s? And for 1.0 s?

Then a colleague writes `ros::Timer timer_ =`, a local variable, in the constructor. When does the callback run now?
Give its first three times, or all if there are fewer; `[]` means none.
"""
REVEALS = "roscpp and rospy time their timers alike. A ros::Timer that is not kept still calls back."

NODE = """
after_0_6_seconds = ...
after_1_0_seconds = ...
not_kept = ...
"""

HINTS = [
    "roscpp arms a timer again when its callback has returned. So at most one call waits.",
    "The next call is due one period after the last one was due. If even the call after that is overdue when the "
    "callback returns, roscpp starts a new grid: the next call is due now.",
    "A `ros::Timer` is a handle, and the timer lives as long as its handles. How long does a variable of the "
    "constructor live?",
]
HINT = "The callback ends at 1.2 s plus the time for which it blocks. Is the call after the next one due by then, too?"

_BUSY = "The slow callback keeps its timer busy until it returns: no other call of it can begin before."

check = predicted(
    after_0_6_seconds=(
        "blocked for 0.6 s",
        [1.8, 2.0, 2.4],
        "The callback begins at 1.2 s and blocks for 0.6 s. Which tick is overdue when it returns?",
        {
            (1.6, 2.0, 2.4): _BUSY,
            (1.8, 2.2, 2.6): "roscpp starts a new grid only if the call after the next one is overdue as well.",
        },
    ),
    after_1_0_seconds=(
        "blocked for 1.0 s",
        [2.2, 2.6, 3.0],
        "The callback begins at 1.2 s and blocks for 1.0 s. Which ticks are overdue when it returns?",
        {
            (1.6, 2.0, 2.4): _BUSY,
            (2.2, 2.2, 2.4): "This is what rospy does. roscpp never has more than one call of a timer waiting.",
            (2.2, 2.4, 2.8): "The timer does not go back to its old grid: after such a delay roscpp begins a new one.",
        },
    ),
    not_kept=(
        "with a timer that is not kept",
        [],
        "What happens to a timer when the last `ros::Timer` that refers to it is gone?",
        {
            (
                0.4,
                0.8,
                1.2,
            ): "This is what rospy does. In C++ a timer ends with the last `ros::Timer` that refers to it.",
        },
    ),
)

SOLUTION = """
# Back at 1.8: tick 4 was due at 1.6, tick 5 at 2.0, which is still to come.
after_0_6_seconds = [1.8, 2.0, 2.4]
# Back at 2.2: tick 4 was due at 1.6, and tick 5 at 2.0 is overdue, too.
# roscpp starts a new grid at 2.2; rospy would have made up for tick 5.
after_1_0_seconds = [2.2, 2.6, 3.0]
# The handle is gone when the constructor returns, and the timer with it.
not_kept = []
"""

RIGHT = [
    {"[]": "()"},
    {"[]": "list()"},
    {"[1.8, 2.0, 2.4]": "[1.2 + 0.6, 2, 2.4]"},
    {"[2.2, 2.6, 3.0]": "tuple(2.2 + n * 0.4 for n in range(3))"},
    {"[2.2, 2.6, 3.0]": "[2.2, 2.6, 3]", "[]": "[]"},
]
WRONG = [
    ({"[1.8, 2.0, 2.4]": "[1.6, 2.0, 2.4]"}, "Blocked for 0.6 s: not 1.6 s", "keeps its timer busy"),
    ({"[1.8, 2.0, 2.4]": "[1.8, 2.2, 2.6]"}, "not 1.8 s, 2.2 s", "only if the call after the next one is overdue"),
    ({"[2.2, 2.6, 3.0]": "[2.2, 2.2, 2.4]"}, "not 2.2 s, 2.2 s", "This is what rospy does"),
    ({"[2.2, 2.6, 3.0]": "[2.2, 2.4, 2.8]"}, "not 2.2 s, 2.4 s", "roscpp begins a new one"),
    ({"[2.2, 2.6, 3.0]": "[1.6, 2.0, 2.4]"}, "Blocked for 1.0 s: not 1.6 s", "keeps its timer busy"),
    ({"[]": "[0.4, 0.8, 1.2]"}, "that is not kept: not 0.4 s", "In C++ a timer ends with the last"),
    ({"[]": "[0.0]"}, "that is not kept: not 0 s", "the last `ros::Timer`"),
    ({"[]": "None"}, "that is not kept: there is no prediction", "Give `not_kept` a list"),
    ({"[]": "0"}, "not a value of type `int`", "Write it as"),
    ({"[1.8, 2.0, 2.4]": "[1.8, 2.0]"}, "3 times are asked for, not 2", "These are right, and one more is asked for"),
]
