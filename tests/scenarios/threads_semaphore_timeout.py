"""Semaphore.acquire with timeouts and without waiting; a release of several."""

import threading

import rospy
from scenario import P, begin, mark, say

semaphore = threading.Semaphore(0)
begin("threads_semaphore_timeout")
timer = rospy.Timer(rospy.Duration(2 * P), lambda event: semaphore.release(3), oneshot=True)
say("without waiting", semaphore.acquire(blocking=False))
say("too short", semaphore.acquire(timeout=P))
mark("too_short")
say("long enough", semaphore.acquire(timeout=3 * P))
mark("long_enough")
say("left", semaphore.acquire(False), semaphore.acquire(False), semaphore.acquire(False))
