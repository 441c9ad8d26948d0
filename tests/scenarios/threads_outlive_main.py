"""The main ends, a thread does not: Python waits for it, and only then the hooks run."""

import threading

import rospy
from scenario import P, begin, block, mark, say


def work():
    for _ in range(3):
        block(1.2)
        mark("work")
    timer.shutdown()
    say("is_shutdown", rospy.is_shutdown())


begin("threads_outlive_main")
rospy.on_shutdown(lambda: mark("hook"))
timer = rospy.Timer(rospy.Duration(0.8 * P), lambda event: mark("tick"))
threading.Thread(target=work).start()
mark("main_ends")
