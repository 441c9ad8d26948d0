"""An exception in a callback is logged, and all continues."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32


class Bad:
    def __repr__(self):
        return "<a bad one>"

    def __call__(self, message):
        if message.data == 1:
            raise ValueError("one is too many")
        say("bad", message.data)


begin("topics_callback_raises")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, Bad())
rospy.Subscriber("~a", UInt32, lambda message: say("good", message.data))
block(1)
for number in range(3):
    publisher.publish(number)
    block(0.5)
