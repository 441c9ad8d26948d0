"""signal.signal works in the main thread only; therefore init_node fails in another one."""

import signal
import threading

import rospy
from scenario import say


def start():
    for call in (lambda: signal.signal(signal.SIGINT, signal.SIG_DFL), lambda: rospy.init_node("threads_signal_in_thread")):
        try:
            call()
        except ValueError as error:
            say(error)


thread = threading.Thread(target=start)
thread.start()
thread.join()
