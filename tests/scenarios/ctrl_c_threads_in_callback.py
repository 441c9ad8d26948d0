"""Ctrl-C while a timer's callback waits for an event: spin returns, without waiting for the callback."""

import threading

import rospy
from scenario import P, begin, mark, say


def callback(event):
    mark("waits")
    threading.Event().wait()
    say("never")


begin("ctrl_c_threads_in_callback")
rospy.on_shutdown(lambda: say("hook"))
timer = rospy.Timer(rospy.Duration(P), callback)
rospy.spin()
say("spin has returned", timer.is_alive())
