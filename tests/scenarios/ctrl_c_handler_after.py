"""A SIGINT handler set after init_node takes rospy's place: the node shuts itself down, when it likes."""

import signal
import threading

import rospy
from scenario import begin, mark, say

stop = threading.Event()


def handle(number, frame):
    mark("handler")
    say("handler", signal.Signals(number).name, rospy.is_shutdown())
    stop.set()


begin("ctrl_c_handler_after")
previous = signal.signal(signal.SIGINT, handle)
say(callable(previous), signal.getsignal(signal.SIGINT) is handle)
rospy.on_shutdown(lambda: say("hook"))
say("woken", stop.wait(), rospy.is_shutdown())
mark("woken")
