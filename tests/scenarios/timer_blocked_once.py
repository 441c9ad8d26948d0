"""The second call of a timer takes ~block periods, then all are quick again. Every field of the events."""

import rospy
from scenario import P, begin, block, end_after, mark_event

calls = []


def callback(event):
    calls.append(event)
    mark_event("tick", event)
    if len(calls) == 2:
        block(rospy.get_param("~block"))


begin("timer_blocked_once")
timer = rospy.Timer(rospy.Duration(P), callback)
end_after(9.5)
