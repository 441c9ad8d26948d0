"""Ctrl-C while wait_for_service() waits, in a node that handles its signals itself."""

import rospy
from scenario import begin

begin("ctrl_c_services_wait_no_signals", disable_signals=True)
rospy.wait_for_service("~a")
