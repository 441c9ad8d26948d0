"""A SIGINT handler of the node's own, set before init_node: rospy calls it after its shutdown."""

import signal
import threading

import rospy
from scenario import P, begin, mark, say


def handle(number, frame):
    say("handler", number == signal.SIGINT, rospy.is_shutdown(), threading.current_thread().name, frame is not None)


signal.signal(signal.SIGINT, handle)
begin("ctrl_c_handler_before")
say("taken", signal.getsignal(signal.SIGINT) is not handle, callable(signal.getsignal(signal.SIGINT)))
rospy.on_shutdown(lambda: say("hook", rospy.is_shutdown()))
rate = rospy.Rate(1 / P)
while not rospy.is_shutdown():
    mark("pass")
    rate.sleep()
say("the loop has ended")
