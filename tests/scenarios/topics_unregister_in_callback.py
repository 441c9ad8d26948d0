"""A Subscriber that unregisters in its callback is not called again; its neighbour is."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32


def once(message):
    say("once", message.data)
    subscriber.unregister()


begin("topics_unregister_in_callback")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
subscriber = rospy.Subscriber("~a", UInt32, once)
other = rospy.Subscriber("~a", UInt32, lambda message: say("other", message.data))
block(1)
for number in range(3):
    publisher.publish(number)
    block(0.5)
other.unregister()
other.unregister()
publisher.publish(3)
block(1)
