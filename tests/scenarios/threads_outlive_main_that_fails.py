"""The main dies of an exception: its traceback comes at once, the status after the threads."""

import threading

import rospy
from scenario import begin, block, mark


def work():
    block(2)
    mark("work")


begin("threads_outlive_main_that_fails")
rospy.on_shutdown(lambda: mark("hook"))
threading.Thread(target=work).start()
block(0.5)
raise RuntimeError("the main fails")
