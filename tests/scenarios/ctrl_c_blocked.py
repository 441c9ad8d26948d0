"""Ctrl-C while a callback is blocked: spin returns, the process does not wait for the callback."""

import rospy
from scenario import P, begin, block, mark_event


def callback(event):
    mark_event("tick", event)
    block(20)
    print("never", flush=True)


begin("ctrl_c_blocked")
rospy.Timer(rospy.Duration(P), callback)
rospy.spin()
print("spin has returned", flush=True)
