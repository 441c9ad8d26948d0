"""A Rate whose period is changed while it runs, and whose current period is said to begin now."""

import rospy
from scenario import P, begin, block, mark

begin("rate_changed")
rate = rospy.Rate(1 / P)
for period in (None, None, 2, None, 0.5, None, None):
    if period:
        rate.sleep_dur = rospy.Duration(period * P)
    block(0.25)
    rate.sleep()
    mark("pass", rate.last_time)
    mark("now")
block(1.25)
rate.last_time = rospy.Time.now()
rate.sleep()
mark("end")
