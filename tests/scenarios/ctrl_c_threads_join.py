"""Ctrl-C while the main joins a thread whose Rate loop sees the shutdown."""

import threading

import rospy
from scenario import P, begin, mark, say


def loop():
    rate = rospy.Rate(1 / P)
    while not rospy.is_shutdown():
        mark("pass")
        rate.sleep()
    say("the loop has ended")


begin("ctrl_c_threads_join")
rospy.on_shutdown(lambda: say("hook", threading.current_thread().name))
worker = threading.Thread(target=loop)
worker.start()
worker.join()
say("joined", rospy.is_shutdown())
