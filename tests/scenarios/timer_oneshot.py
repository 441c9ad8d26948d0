"""A timer that fires once, and its thread afterwards."""

import rospy
from scenario import P, begin, end_after, mark_event


def callback(event):
    mark_event("tick", event)


begin("timer_oneshot")
timer = rospy.Timer(rospy.Duration(P), callback, oneshot=True)
print("alive", timer.is_alive())
timer.join(3 * P)
print("alive", timer.is_alive())
end_after(2)
