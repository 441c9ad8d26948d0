"""Each topic has a thread of its own: a slow callback does not hold up another topic's."""

import rospy
from scenario import P, begin, block, end_after, mark
from std_msgs.msg import UInt32


def slow(message):
    mark("slow")
    block(2.5)


def quick(message):
    mark("quick")


begin("topics_parallel")
publishers = [rospy.Publisher(name, UInt32, queue_size=10) for name in ("~a", "~b")]
rospy.Subscriber("~a", UInt32, slow)
rospy.Subscriber("~b", UInt32, quick)
block(1)
for number in range(3):
    for publisher in publishers:
        publisher.publish(number)
    rospy.sleep(P)
end_after(6)
