"""A Rate made with reset paces as any other on wall time."""

import rospy
from scenario import P, begin, block, mark, now

begin("rate_reset")
rate = rospy.Rate(1 / P, reset=True)
while now() < 5.25 * P:
    mark("pass")
    if now() < 0.5 * P:
        block(1.5)
    rate.sleep()
