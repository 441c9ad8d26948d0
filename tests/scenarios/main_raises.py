"""An exception in the main: a traceback, the hooks, status 1."""

import rospy


def fail():
    raise ValueError("the main fails")


rospy.init_node("main_raises")
rospy.on_shutdown(lambda: print("hook", flush=True))
fail()
