"""sys.exit in a callback ends that timer in silence, not the node."""

import sys

import rospy
from scenario import P, begin, end_after, mark_event


def callback(event):
    mark_event("tick", event)
    sys.exit(3)


begin("callback_exits")
timer = rospy.Timer(rospy.Duration(P), callback)
end_after(3.5)
print("alive", timer.is_alive())
