"""Ends of different types do not connect: the publisher says so, the subscriber does not."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import Empty, String

begin("topics_mismatch")
publisher = rospy.Publisher("~a", Empty, queue_size=1)
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
block(1)
publisher.publish()
say("connections", publisher.get_num_connections())
block(0.5)
