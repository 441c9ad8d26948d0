"""A Rate loop in the main and a timer; each is blocked once and the other continues."""

import rospy
from scenario import P, begin, block, mark, mark_event, now

calls = []


def callback(event):
    calls.append(event)
    mark_event("tick", event)
    if len(calls) == 4:
        block(2.5)


begin("timer_beside_rate")
rospy.Timer(rospy.Duration(P), callback)
rate = rospy.Rate(1 / P)
number = 0
while now() < 9.25 * P:
    number += 1
    mark("pass")
    if number == 2:
        block(2.5)
    rate.sleep()
mark("end")
