"""Ctrl-C does not end a sleep on wall time, and raises nothing; the hooks run at once."""

import rospy
from scenario import P, begin, mark

begin("ctrl_c_long_sleep")
rospy.on_shutdown(lambda: mark("hook"))
try:
    rospy.sleep(8 * P)
except rospy.ROSInterruptException as error:
    print("interrupted", error)
mark("slept")
print("is_shutdown", rospy.is_shutdown(), flush=True)
