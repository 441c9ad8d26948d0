"""Ctrl-C ends spin; the lines after it still run."""

import rospy
from scenario import P, begin, mark_event

begin("ctrl_c_spin")
rospy.on_shutdown(lambda: print("hook", rospy.is_shutdown(), flush=True))
rospy.Timer(rospy.Duration(P), lambda event: mark_event("tick", event))
rospy.spin()
print("spin has returned", rospy.is_shutdown(), flush=True)
