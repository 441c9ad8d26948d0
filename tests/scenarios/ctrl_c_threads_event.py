"""Ctrl-C while the main waits for an event that a shutdown hook sets."""

import threading

import rospy
from scenario import begin, say

stop = threading.Event()
begin("ctrl_c_threads_event")
rospy.on_shutdown(stop.set)
say("woken", stop.wait())
say("is_shutdown", rospy.is_shutdown())
