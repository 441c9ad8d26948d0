"""A callback that fails between acquire and release never releases the lock: the other timer ticks no more."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark

lock = threading.Lock()
calls = []


def fail(event):
    lock.acquire()
    mark("takes")
    calls.append(event)
    if len(calls) == 2:
        raise RuntimeError("before release")
    lock.release()


def work(event):
    mark("due")
    with lock:
        mark("works")


begin("threads_lock_kept_after_exception")
rospy.Timer(rospy.Duration(P), fail)
block(0.5)
working = rospy.Timer(rospy.Duration(P), work)
end_after(5)
print("alive", working.is_alive(), "locked", lock.locked())
