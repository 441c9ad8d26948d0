"""signal.signal works in the main thread only; therefore init_node fails in another one."""

import signal
import threading

import rospy
from scenario import say


def start():
    try:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    except ValueError as error:
        say(error)
    try:
        rospy.init_node("threads_signal_in_thread")
    except ValueError as error:
        say(error)


thread = threading.Thread(target=start)
thread.start()
thread.join()
