"""Two timers change a counter: what is read before a wait is lost without a lock, and kept with one."""

import threading

import rospy
from scenario import P, begin, block, end_after, say

counter = {"bare": 0, "locked": 0}
lock = threading.Lock()


def count_bare(event):
    value = counter["bare"]
    block(1)
    counter["bare"] = value + 1


def count_locked(event):
    with lock:
        value = counter["locked"]
        block(1)
        counter["locked"] = value + 1


begin("threads_lost_update")
rospy.Timer(rospy.Duration(P), count_bare, oneshot=True)
rospy.Timer(rospy.Duration(P), count_locked, oneshot=True)
block(0.5)
rospy.Timer(rospy.Duration(P), count_bare, oneshot=True)
rospy.Timer(rospy.Duration(P), count_locked, oneshot=True)
end_after(4)
say(counter)
