"""A publisher can be made when it is needed: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..odd_nodes import HEAD

TITLE = "Publish the counter"
TEXT = """
**You need**: [the second tutorial](../docs/publish.rst).

The listener waits for `std_msgs/UInt32` messages on the topic `counter`. Publish 1, 2, 3 and so on there, five times a
second, beginning one period after the start. The listener must receive them all.
"""
REVEALS = "A publisher can be made when it is needed. A topic is found by its type."

NODE = """
import rospy
from std_msgs.msg import UInt32


class Listener:
    def __init__(self):
        rospy.Subscriber("counter", UInt32, self.counterCallback)

    def counterCallback(self, message):
        rospy.loginfo("[LISTENER] counter = " + str(message.data))


class PublisherPyNode:
    def __init__(self):
        self.counter = 0
        rospy.Timer(rospy.Duration(0.5), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1


if __name__ == '__main__':
    rospy.init_node("publisher_py_node")
    listener = Listener()
    publisher_py_node = PublisherPyNode()
    rospy.spin()
"""

NODE_CPP = """
#include "ros/ros.h"
#include "std_msgs/UInt32.h"

class Listener
{
public:
  Listener()
  {
    subscriber_ = nh_.subscribe("counter", 10, &Listener::counterCallback, this);
  }

private:
  void counterCallback(const std_msgs::UInt32& message)
  {
    ROS_INFO_STREAM("[LISTENER] counter = " << message.data);
  }

  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
};

class PublisherCppNode
{
public:
  PublisherCppNode()
  {
    timer_ = nh_.createTimer(ros::Duration(0.5), &PublisherCppNode::timerCallback, this);
  }

private:
  void timerCallback(const ros::TimerEvent&)
  {
    counter_++;
  }

  ros::NodeHandle nh_;
  ros::Timer timer_;
  unsigned int counter_ = 0;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "publisher_cpp_node");
  Listener listener;
  PublisherCppNode publisher_cpp_node;
  ros::spin();
  return 0;
}
"""

HINTS = [
    "The publisher is missing, and a line that uses it. Where does each belong?",
    "`rospy.Publisher` takes the name of the topic, the type of its messages, and a `queue_size`.",
    "A new publisher takes a moment to connect: the timer's callback is too late to make one.",
    "Five times a second: what is the period?",
]
HINTS_CPP = [
    "The publisher is missing, and lines that use it. Where does each belong?",
    "`nh_.advertise<Type>` is given the name of the topic, and how many messages may wait. A member of the class keeps "
    "what it returns, a `ros::Publisher`.",
    "A new publisher takes a moment to connect to another process: the timer's callback is too late to make one.",
    "Five times a second: what is the period?",
]
HINT = 'Make a `rospy.Publisher("counter", UInt32, queue_size=10)` in `__init__`, and publish in the callback.'
HINT_CPP = (
    'Make the publisher in the constructor, `nh_.advertise<std_msgs::UInt32>("counter", 10)`, and publish in the '
    "callback."
)

check = by.published_and_heard

SOLUTION = {
    "        rospy.Timer(rospy.Duration(0.5), self.timerCallback)\n": (
        '        self.publisher = rospy.Publisher("counter", UInt32, queue_size=10)\n'
        "        rospy.Timer(rospy.Duration(0.2), self.timerCallback)\n"
    ),
    "        self.counter += 1\n": "        self.counter += 1\n        self.publisher.publish(self.counter)\n",
}

PUBLISHER = 'self.publisher = rospy.Publisher("counter", UInt32, queue_size=10)'
PUBLISH = "self.publisher.publish(self.counter)"
IN_CALLBACK = {  # the publisher is made in the callback
    f"        {PUBLISHER}\n": "",
    PUBLISH: f"{PUBLISHER}\n        {PUBLISH}",
}
LISTENS = f"""{HEAD}from std_msgs.msg import UInt32
rospy.Subscriber("counter", UInt32, lambda message: rospy.loginfo("[LISTENER] counter = %d", message.data))
publisher = rospy.Publisher("/counter", UInt32, queue_size=1)
"""

RIGHT = [
    {"publish(self.counter)": "publish(data=self.counter)"},
    {"publish(self.counter)": "publish(UInt32(self.counter))"},
    {"UInt32, queue_size=10": "UInt32, latch=True, queue_size=1"},
    {PUBLISHER: PUBLISHER.replace('"counter"', '"/counter"'), "Duration(0.2)": "Duration(1 / 5)"},
    {PUBLISHER: PUBLISHER.replace(", queue_size=10", "")},
    LISTENS + "for count in range(1, 100):\n    rospy.sleep(0.2)\n    if rospy.is_shutdown():\n        break\n"
    "    publisher.publish(count)\n",
    LISTENS + "rate = rospy.Rate(5)\ncount = 0\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
    "    count += 1\n    publisher.publish(count)\n",
    LISTENS + "from itertools import count\ncounts = count(1)\n"
    "rospy.Timer(rospy.Duration(0.2), lambda event: publisher.publish(next(counts)))\nrospy.spin()\n",
]
WRONG = [
    (
        {f"        {PUBLISH}\n": ""},
        "on `/counter`: the node published nothing",
        "There is a publisher, but nothing publishes with it.",
    ),
    (IN_CALLBACK, "The listener: where counter 1 was due, counter 2 came", "Make it once, before the timer"),
    (
        {PUBLISHER: PUBLISHER.replace('"counter"', '"count"')},
        "it was published on `/count`",
        "The publisher uses the listener's topic, letter by letter:",
    ),
    (
        {PUBLISHER: PUBLISHER.replace('"counter"', '"~counter"')},
        "on `/publisher_py_node/counter`",
        "The publisher uses the listener's topic, letter by letter:",
    ),
    (
        {PUBLISHER: PUBLISHER.replace("UInt32", "Int32"), "import UInt32": "import Int32, UInt32"},
        "are of the type std_msgs/Int32",
        "have to name the same type",
    ),
    (
        {"Duration(0.2)": "Duration(5)"},
        "nothing was published on `/counter`",
        "Five times a second is once in 1 / 5 s.",
    ),
    (
        {"Duration(0.2)": "Duration(0.5)"},
        "On `/counter`: counter 1 came at 0.5 s, not at 0.2 s",
        "Five times a second is once in 1 / 5 s.",
    ),
    (
        {"        self.counter += 1\n": "", PUBLISH: f"{PUBLISH}\n        self.counter += 1"},
        "where counter 1 was due, counter 0 came",
        "The first counter is 1:",
    ),
    (
        {"publish(self.counter)": "publish(str(self.counter))"},
        "timer stopped in line 21:",
        "A field of a message takes values of its own type only.",
    ),
    (
        {"publish(self.counter)": "publish()"},
        "on `/counter`: each message holds 0, not a counter.",
        "A new message holds 0.",
    ),
    (
        {PUBLISHER: PUBLISHER.replace("UInt32, ", "")},
        "missing 1 required positional",
        '`rospy.Publisher("topic", UInt32, queue_size=10)`:',
    ),
    ({"self.publisher.": "self.pub."}, "has no attribute 'pub'", "with its `self.`"),
    (
        {PUBLISH: f"{PUBLISH}\n        {PUBLISH}"},
        "On `/counter`: where counter 2 was due, counter 1 came",
        "A counter comes more than once:",
    ),
    (
        {"[LISTENER] counter": "[LISTENER] number"},
        "The listener: no counter was printed",
        "Leave the listener as it is",
    ),
    ({"str(message.data)": "str(message)"}, "The listener: where counter 1 was due", "and the number in the message"),
    (
        {PUBLISHER: f"rospy.sleep(1.0)\n        {PUBLISHER}"},
        "On `/counter`: counter 1 came at 1.2 s",
        "They come every 0.2 s, as asked for, but 1 s late.",
    ),
    (
        {
            "    listener = Listener()\n": "",
            "PublisherPyNode()\n": "PublisherPyNode()\n    rospy.sleep(1)\n    listener = Listener()\n",
        },
        "The listener: where counter 1 was due, counter 6 came",
        "The listener subscribes only at 1 s.",
    ),
    (
        {"        rospy.Subscriber": "        pass  # "},
        "The listener: no counter",
        "Nothing subscribes to `/counter` any more.",
    ),
]

TIMER_CPP = "    timer_ = nh_.createTimer(ros::Duration(0.5), &PublisherCppNode::timerCallback, this);\n"
MAKES_CPP = '    publisher_ = nh_.advertise<std_msgs::UInt32>("counter", 10);\n'
PUBLISHES_CPP = "    std_msgs::UInt32 message;\n    message.data = counter_;\n    publisher_.publish(message);\n"

SOLUTION_CPP = {
    TIMER_CPP: MAKES_CPP + TIMER_CPP.replace("0.5", "0.2"),
    "    counter_++;\n": "    counter_++;\n" + PUBLISHES_CPP,
    "  ros::Timer timer_;\n": "  ros::Publisher publisher_;\n  ros::Timer timer_;\n",
}

RIGHT_CPP = [
    {'"counter", 10);\n    timer_': '"/counter", 1);\n    timer_'},
    {"Duration(0.2)": "Duration(1 / 5.0)"},
    {
        PUBLISHES_CPP: "    boost::shared_ptr<std_msgs::UInt32> message(new std_msgs::UInt32);\n"
        "    message->data = counter_;\n    publisher_.publish(message);\n"
    },
    {MAKES_CPP: MAKES_CPP.replace("10)", "10, true)")},
]
WRONG_CPP = [
    (
        {MAKES_CPP: "", PUBLISHES_CPP: MAKES_CPP + PUBLISHES_CPP},
        "the publisher was made at 0.2 s, when its first message was",
        "A publisher that was made just now may not be connected",
    ),
    (
        {MAKES_CPP: "", PUBLISHES_CPP: f"    if (!publisher_)\n  {MAKES_CPP}{PUBLISHES_CPP}"},
        "the publisher was made at 0.2 s",
        "Make it once, before the timer",
    ),
    (
        {"    publisher_.publish(message);\n": ""},
        "on `/counter`: the node published nothing",
        "nothing publishes with it",
    ),
    ({"    message.data = counter_;\n": ""}, "on `/counter`: each message holds 0", "A new message holds 0."),
    ({'"counter", 10);\n    timer_': '"count", 10);\n    timer_'}, "it was published on `/count`", "letter by letter"),
    ({"Duration(0.2)": "Duration(0.5)"}, "On `/counter`: counter 1 came at 0.5 s, not at 0.2 s", "Five times a second"),
    ({MAKES_CPP: ""}, "The node stopped with `abort()`.", "What threw this says in its own words what was wrong, and"),
    (
        {
            "advertise<std_msgs::UInt32>": "advertise<std_msgs::String>",
            '#include "std_msgs/UInt32.h"': '#include "std_msgs/String.h"\n#include "std_msgs/UInt32.h"',
        },
        "The node stopped with `abort()`.",
        "What threw this says in its own words what was wrong, and",
    ),
]
