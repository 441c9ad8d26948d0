"""The Subscribers of one topic share its queue: the last one who sets its size decides."""

import rospy
from scenario import P, begin, block, end_after, say
from std_msgs.msg import UInt32


def slow(message):
    say("slow", message.data)
    block(3.3)


begin("topics_queue_sizes_shared")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, slow, queue_size=1)
rospy.Subscriber("~a", UInt32, lambda message: say("quick", message.data), queue_size=2)
block(1)
for number in range(7):
    publisher.publish(number)
    rospy.sleep(P)
end_after(7)
