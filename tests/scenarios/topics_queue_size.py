"""A slow callback: what a subscriber's queue_size (0: none) keeps of ten messages, one in each period."""

import rospy
from scenario import P, begin, block, end_after, mark, say
from std_msgs.msg import UInt32


def slow(message):
    say("got", message.data)
    mark("called")
    block(3.3)


begin("topics_queue_size")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, slow, queue_size=rospy.get_param("~queue_size") or None)
block(1)
for number in range(10):
    publisher.publish(number)
    rospy.sleep(P)
end_after(3.7)
