"""A SIGINT handler that calls sys.exit ends the main with that status, after the threads."""

import signal
import sys
import threading

import rospy
from scenario import begin, block, mark, say


def work():
    block(5)
    mark("work")


begin("ctrl_c_handler_exits")
signal.signal(signal.SIGINT, lambda number, frame: sys.exit(5))
rospy.on_shutdown(lambda: say("hook"))
threading.Thread(target=work).start()
rospy.spin()
say("never")
