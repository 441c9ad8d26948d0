"""The main has ended, Ctrl-C reaches the node all the same: the thread that Python waits for sees the shutdown."""

import threading

import rospy
from scenario import P, begin, mark, mark_event, say


def loop():
    rate = rospy.Rate(1 / P)
    while not rospy.is_shutdown():
        mark("pass")
        rate.sleep()
    say("the loop has ended")


begin("ctrl_c_threads_outlive_main")
rospy.on_shutdown(lambda: say("hook", threading.current_thread().name))
rospy.Timer(rospy.Duration(1.5 * P), lambda event: mark_event("tick", event))
threading.Thread(target=loop).start()
say("the main ends")
