"""A serialization error that is not caught ends the main; its traceback is printed."""

import rospy
from scenario import begin, block
from std_msgs.msg import String

begin("topics_publish_raises")
publisher = rospy.Publisher("~a", String, queue_size=10)
rospy.Subscriber("~a", String)
block(1)
publisher.publish(5)
