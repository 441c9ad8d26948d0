"""Ctrl-C while wait_for_message() waits."""

import rospy
from scenario import begin, say
from std_msgs.msg import UInt32

begin("ctrl_c_topics_wait_for_message")
try:
    rospy.wait_for_message("nope", UInt32)
except rospy.ROSInterruptException as error:
    say(type(error).__name__, error, rospy.is_shutdown())
