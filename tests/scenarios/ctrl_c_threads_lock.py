"""Ctrl-C while the main waits for a lock: it keeps waiting until a thread that saw the shutdown releases it."""

import threading

import rospy
from scenario import begin, block, say

lock = threading.Lock()


def hold():
    with lock:
        while not rospy.is_shutdown():
            block(0.5)


begin("ctrl_c_threads_lock")
rospy.on_shutdown(lambda: say("hook", lock.locked()))
threading.Thread(target=hold).start()
block(0.5)
with lock:
    say("locked")
say("is_shutdown", rospy.is_shutdown())
