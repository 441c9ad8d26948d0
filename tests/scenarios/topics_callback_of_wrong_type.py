"""What cannot be called, or takes no argument, is found when a message comes."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32


class Neither:
    def __repr__(self):
        return "<neither>"


class NoArgument(Neither):
    def __call__(self):
        pass


begin("topics_callback_of_wrong_type")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, Neither())
rospy.Subscriber("~a", UInt32, NoArgument())
block(1)
publisher.publish(1)
block(0.5)
say("goes on")
