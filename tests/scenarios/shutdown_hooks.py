"""Hooks run in the order of their registration, and before the shutdown; one that comes too late runs at once."""

import rospy
from scenario import begin, block, mark


def hook(name, periods=0.0):
    def run():
        print("hook", name, rospy.is_shutdown(), rospy.core.is_shutdown_requested(), flush=True)
        block(periods)
        mark(name)

    return run


begin("shutdown_hooks")
rospy.on_shutdown(hook("first"))
rospy.on_shutdown(hook("second", 1.5))
rospy.on_shutdown(hook("third"))
try:
    rospy.on_shutdown("no function")
except TypeError as error:
    print("TypeError:", error)
block(1)
rospy.signal_shutdown("reason")
rospy.signal_shutdown("again")
print("is_shutdown", rospy.is_shutdown(), flush=True)
rospy.on_shutdown(lambda: print("hook late", flush=True))
