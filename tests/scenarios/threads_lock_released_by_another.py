"""A lock has no owner: a callback may release what the main has taken."""

import threading

import rospy
from scenario import P, begin, mark, say

lock = threading.Lock()
begin("threads_lock_released_by_another")
lock.acquire()
timer = rospy.Timer(rospy.Duration(1.5 * P), lambda event: lock.release(), oneshot=True)
lock.acquire()
mark("again")
timer.join()
say("locked", lock.locked(), "alive", timer.is_alive())
