"""Ctrl-C ignored after init_node: the node continues, until a threading.Timer shuts it down."""

import signal
import threading

import rospy
from scenario import P, begin, mark, say

begin("ctrl_c_handler_ignored")
signal.signal(signal.SIGINT, signal.SIG_IGN)
rospy.on_shutdown(lambda: mark("hook"))
timer = threading.Timer(6.5 * P, rospy.signal_shutdown, ["time is up"])
timer.start()
rospy.sleep(5 * P)
mark("slept")
say("is_shutdown", rospy.is_shutdown())
timer.join()
say("is_shutdown", rospy.is_shutdown())
