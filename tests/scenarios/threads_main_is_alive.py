"""A worker that runs as long as the main thread is alive ends with it."""

import threading

import rospy
from scenario import begin, block, mark, say


def work():
    while threading.main_thread().is_alive():
        mark("work")
        block(1)
    say("the main has ended", rospy.is_shutdown())


begin("threads_main_is_alive")
threading.Thread(target=work).start()
block(2.5)
mark("main_ends")
