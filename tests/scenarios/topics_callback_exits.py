"""SystemExit in a callback ends nothing."""

import sys

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32


def exits(message):
    say("got", message.data)
    if message.data == 1:
        sys.exit(3)


begin("topics_callback_exits")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, exits)
rospy.Subscriber("~a", UInt32, lambda message: say("after it", message.data))
block(1)
for number in range(3):
    publisher.publish(number)
    block(0.5)
