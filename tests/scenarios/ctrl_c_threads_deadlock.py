"""Two timers that take two locks in opposite order block each other for good; a third ticks on, Ctrl-C ends spin."""

import threading

import rospy
from scenario import P, begin, block, mark, mark_event, say

left, right = threading.Lock(), threading.Lock()


def callback(name, first, second):
    def call(event):
        with first:
            mark(f"{name}_first")
            block(0.5)
            with second:
                say("never")

    return call


begin("ctrl_c_threads_deadlock")
rospy.Timer(rospy.Duration(P), callback("left", left, right))
rospy.Timer(rospy.Duration(P), callback("right", right, left))
rospy.Timer(rospy.Duration(1.25 * P), lambda event: mark_event("tick", event))
rospy.spin()
say("spin has returned")
