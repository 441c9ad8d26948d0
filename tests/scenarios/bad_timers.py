"""Periods that are none end the timer's own thread, and the node does not notice."""

import rospy
from scenario import P, begin, block

begin("bad_timers")
for period in (rospy.Duration(0), rospy.Time(1), 0.5, None, "1"):
    timer = rospy.Timer(period, print)
    block(0.5)
    print("alive", timer.is_alive(), flush=True)
timer = rospy.Timer(rospy.Duration(0.5 * P), None)
block(1)
print("alive", timer.is_alive(), flush=True)
for arguments in ((), (rospy.Duration(1),)):
    try:
        rospy.Timer(*arguments)
    except TypeError as error:
        print(error)
