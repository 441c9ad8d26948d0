"""Ends of different types do not connect: the publisher says so, the subscriber does not."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String, UInt32

begin("topics_mismatch")
publisher = rospy.Publisher("~a", UInt32, queue_size=1)
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
block(1)
publisher.publish(1)
say("connections", publisher.get_num_connections())
block(0.5)
