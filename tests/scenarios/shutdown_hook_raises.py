"""A hook that raises: it is told on stderr, and the next one runs."""

import rospy
from scenario import begin


def broken():
    print("broken", flush=True)
    raise ValueError("a hook that is broken")


def after():
    print("after", flush=True)


begin("shutdown_hook_raises")
rospy.on_shutdown(broken)
rospy.on_shutdown(after)
rospy.signal_shutdown("reason")
print("is_shutdown", rospy.is_shutdown(), flush=True)
