"""Ctrl-C in a Rate loop: no traceback, the loop ends after its sleep."""

import rospy
from scenario import P, begin, mark

begin("ctrl_c_rate")
rate = rospy.Rate(1 / P)
while not rospy.is_shutdown():
    mark("pass")
    rate.sleep()
print("the loop has ended", flush=True)
