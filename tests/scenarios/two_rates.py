"""Two rates in one loop: the slower one paces it, the faster one never sleeps long."""

import rospy
from scenario import P, begin, mark, now

begin("two_rates")
quick, slow = rospy.Rate(2 / P), rospy.Rate(0.5 / P)
while now() < 9 * P:
    mark("pass")
    quick.sleep()
    mark("quick")
    slow.sleep()
    mark("slow")
mark("end")
