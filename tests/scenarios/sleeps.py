"""rospy.sleep of numbers and durations, negative ones and zero."""

import rospy
from scenario import P, begin, mark

begin("sleeps")
for length in (P, rospy.Duration(P), 0, rospy.Duration(0), -1, -1.5, rospy.Duration(-1), True and 1):
    print("sleep", length, "->", rospy.sleep(length), flush=True)
    mark("after")
for length in ("1", None, [1]):
    try:
        rospy.sleep(length)
    except Exception as error:
        print(type(error).__name__, error)
