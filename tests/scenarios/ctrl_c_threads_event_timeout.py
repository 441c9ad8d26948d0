"""Ctrl-C does not wake a main that waits for an event with a timeout: it waits to its end, and raises nothing."""

import threading

import rospy
from scenario import P, begin, mark, say

begin("ctrl_c_threads_event_timeout")
rospy.on_shutdown(lambda: mark("hook"))
say("timeout", threading.Event().wait(7 * P))
mark("timeout")
say("is_shutdown", rospy.is_shutdown())
