"""Ctrl-C while wait_for_service() waits."""

import rospy
from scenario import begin, say

begin("ctrl_c_services_wait")
try:
    rospy.wait_for_service("~a")
except rospy.ROSInterruptException as error:
    say(type(error).__name__, error, rospy.is_shutdown())
