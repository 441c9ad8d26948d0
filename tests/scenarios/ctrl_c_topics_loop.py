"""Ctrl-C in a loop that publishes and a callback that takes long."""

import rospy
from scenario import P, begin, block, mark, say
from std_msgs.msg import UInt32


def heard(message):
    mark("heard")
    block(0.6)


begin("ctrl_c_topics_loop")
publisher = rospy.Publisher("~a", UInt32, queue_size=1)
rospy.Subscriber("~a", UInt32, heard)
block(1.2)
rate = rospy.Rate(1 / P)
number = 0
try:
    while not rospy.is_shutdown():
        publisher.publish(number)
        number += 1
        rate.sleep()
except rospy.ROSInterruptException:
    say("interrupted")
say("passes", number)
