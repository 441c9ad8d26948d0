"""sys.exit in the main waits for the other threads, too; os._exit in one of them does not."""

import os
import sys
import threading

import rospy
from scenario import begin, block, mark


def work():
    block(2)
    mark("work")
    if rospy.myargv()[1] == "hard":
        os._exit(4)


begin("threads_outlive_main_that_exits")
rospy.on_shutdown(lambda: mark("hook"))
threading.Thread(target=work).start()
block(0.5)
sys.exit(3)
