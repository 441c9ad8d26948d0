"""An exception in a callback ends that timer, with a traceback, and no other."""

import rospy
from scenario import P, begin, end_after, mark_event

calls = []


def bad(event):
    calls.append(event)
    mark_event("bad", event)
    if len(calls) == 2:
        raise RuntimeError("the callback fails")


begin("callback_raises")
timer = rospy.Timer(rospy.Duration(P), bad)
rospy.Timer(rospy.Duration(P), lambda event: mark_event("good", event))
end_after(5.5)
print("alive", timer.is_alive())
