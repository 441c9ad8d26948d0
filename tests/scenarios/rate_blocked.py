"""Pass number ~pass of a Rate loop (0: each) takes ~block periods, and sleep() returns None all the same."""

import rospy
from scenario import P, begin, block, mark, now

begin("rate_blocked")
rate = rospy.Rate(1 / P)
number = 0
while now() < 9.25 * P:
    number += 1
    mark("pass")
    if rospy.get_param("~pass") in (0, number):
        block(rospy.get_param("~block"))
    before = now()
    result = rate.sleep()
    mark("slept", before, now())
    if result is not None:
        print("sleep returned", result)
mark("end")
