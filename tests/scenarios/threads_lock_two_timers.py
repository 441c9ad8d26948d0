"""The callbacks of two timers share a lock: the second one waits until the first has left it."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark

lock = threading.Lock()


def callback(name, periods):
    def call(event):
        mark(f"{name}_due")
        with lock:
            mark(f"{name}_in")
            block(periods)
        mark(f"{name}_out")

    return call


begin("threads_lock_two_timers")
rospy.Timer(rospy.Duration(3 * P), callback("first", 1.5))
block(0.5)
rospy.Timer(rospy.Duration(3 * P), callback("second", 0.5))
end_after(6.5)
