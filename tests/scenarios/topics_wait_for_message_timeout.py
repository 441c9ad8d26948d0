"""wait_for_message() with a timeout, in seconds or as a Duration, of what is never published."""

import rospy
from scenario import P, begin, mark, say
from std_msgs.msg import UInt32

begin("topics_wait_for_message_timeout")
for timeout in (2 * P, rospy.Duration(P), 0):
    try:
        say(rospy.wait_for_message("nope", UInt32, timeout))
    except rospy.ROSException as error:
        say(type(error).__name__, error)
    mark("timeout")
