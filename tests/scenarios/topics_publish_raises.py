"""A serialization error that is not caught ends the main; its traceback is printed."""

import rospy
from scenario import begin, block
from std_msgs.msg import UInt32

begin("topics_publish_raises")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32)
block(1)
publisher.publish(-1)
