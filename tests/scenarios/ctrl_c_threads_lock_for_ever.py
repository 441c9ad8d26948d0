"""The main waits for a lock that is never released: Ctrl-C runs the hooks, and then the node must be killed."""

import threading

import rospy
from scenario import begin, mark, say

lock = threading.Lock()
begin("ctrl_c_threads_lock_for_ever")
rospy.on_shutdown(lambda: mark("hook"))
lock.acquire()
lock.acquire()
say("never")
