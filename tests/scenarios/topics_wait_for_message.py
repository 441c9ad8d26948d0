"""wait_for_message() returns the next message, or the latched one."""

import rospy
from scenario import P, begin, mark, say
from std_msgs.msg import String, UInt32

begin("topics_wait_for_message")
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
latching = rospy.Publisher("~b", String, queue_size=10, latch=True)
latching.publish("latched")
rospy.Timer(rospy.Duration(P), lambda event: publisher.publish(7), oneshot=True)
message = rospy.wait_for_message("~a", UInt32)
mark("message")
latched = rospy.wait_for_message("~b", String, timeout=5)
mark("latched")
say("message", message)
say("latched", latched)
say("connections", publisher.get_num_connections() <= 1)
