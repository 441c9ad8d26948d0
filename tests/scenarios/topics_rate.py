"""A loop that publishes at a rate, and a callback that takes longer than a period."""

import rospy
from scenario import P, begin, block, mark, say
from std_msgs.msg import UInt32


def heard(message):
    mark("heard")
    say(message.data)
    block(1.4)


begin("topics_rate")
publisher = rospy.Publisher("~a", UInt32, queue_size=1)
rospy.Subscriber("~a", UInt32, heard, queue_size=1)
block(1)
rate = rospy.Rate(1 / P)
for number in range(5):
    mark("pass")
    publisher.publish(number)
    rate.sleep()
block(2)
