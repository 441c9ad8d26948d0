"""A SIGINT handler that raises an exception of its own, which comes out of the main's sleep."""

import signal
import time

import rospy
from scenario import P, begin, mark, say


class Stop(Exception):
    pass


def handle(number, frame):
    raise Stop(f"signal {number}")


begin("ctrl_c_handler_raises")
signal.signal(signal.SIGINT, handle)
rospy.on_shutdown(lambda: say("hook"))
try:
    time.sleep(20 * P)
except Stop as error:
    mark("stopped")
    say(error, rospy.is_shutdown())
