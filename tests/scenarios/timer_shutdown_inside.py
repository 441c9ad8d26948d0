"""A timer that shuts itself down in its third call; the call is finished, another does not come."""

import rospy
from scenario import P, begin, block, end_after, mark, mark_event

calls = []


def callback(event):
    calls.append(event)
    mark_event("tick", event)
    if len(calls) == 3:
        timer.shutdown()
        block(0.5)
        mark("finished")


begin("timer_shutdown_inside")
timer = rospy.Timer(rospy.Duration(P), callback)
timer.join(5 * P)
print("alive", timer.is_alive())
end_after(3)
