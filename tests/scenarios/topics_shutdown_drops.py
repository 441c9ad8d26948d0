"""At shutdown a callback that runs continues to its end, and what waits behind it is dropped."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32


def slow(message):
    say("begins", message.data)
    block(5)
    say("ends", message.data)


begin("topics_shutdown_drops")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, slow)
block(1)
for number in range(4):
    publisher.publish(number)
    block(0.2)
rospy.signal_shutdown("end")
say("shut down")
block(6)
