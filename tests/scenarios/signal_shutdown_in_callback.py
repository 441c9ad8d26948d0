"""A callback ends the node; spin returns, the hook runs first."""

import rospy
from scenario import P, begin, block, mark, mark_event

calls, after = [], []


def hook():
    print("hook: is_shutdown", rospy.is_shutdown(), flush=True)
    mark("hook")


def callback(event):
    calls.append(event)
    mark_event("tick", event)
    if len(calls) == 3:
        rospy.signal_shutdown("enough")
        after.append(rospy.is_shutdown())


begin("signal_shutdown_in_callback")
rospy.on_shutdown(hook)
rospy.Timer(rospy.Duration(P), callback)
rospy.spin()
block(3)  # a real node takes half a second to close its connections
print("spin has returned", after, flush=True)
