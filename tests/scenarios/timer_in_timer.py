"""Timers made inside a timer's callback: they count from then, and outlive the call."""

import rospy
from scenario import P, begin, end_after, mark_event

calls = []


def outer(event):
    calls.append(event)
    mark_event("outer", event)
    if len(calls) == 2:
        rospy.Timer(rospy.Duration(1.5 * P), lambda inner: mark_event("inner", inner))
    if len(calls) == 3:
        rospy.Timer(rospy.Duration(0.5 * P), lambda once: mark_event("once", once), oneshot=True)


begin("timer_in_timer")
rospy.Timer(rospy.Duration(P), outer)
end_after(8.25)
