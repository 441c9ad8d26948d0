"""A threading.Timer that starts the next one after its work drifts; a rospy.Timer does not."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark


def call():
    mark("chain")
    block(0.5)
    if not rospy.is_shutdown():
        threading.Timer(P, call).start()


def callback(event):
    mark("tick")
    block(0.5)


begin("threads_timer_chain")
threading.Timer(P, call).start()
rospy.Timer(rospy.Duration(P), callback)
end_after(6.6)
