"""One thread runs all callbacks of a topic: message by message, in the order in which the Subscribers were made."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import UInt32

begin("topics_order")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
for name in "ABC":
    rospy.Subscriber("~a", UInt32, lambda message, name: say(name, message.data), name)
block(1)
for number in range(4):
    publisher.publish(number)
block(1)
