"""A callback that fails within ``with lock`` leaves the lock free for the other timer."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark

lock = threading.Lock()


def fail(event):
    with lock:
        mark("fails")
        block(1)
        raise RuntimeError("in the lock")


def work(event):
    with lock:
        mark("works")


begin("threads_lock_and_exception")
failing = rospy.Timer(rospy.Duration(P), fail)
block(0.5)
rospy.Timer(rospy.Duration(P), work)
end_after(4.25)
print("alive", failing.is_alive(), "locked", lock.locked())
