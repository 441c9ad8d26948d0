"""default_int_handler put back after init_node: a KeyboardInterrupt comes out of the main's sleep, and is caught."""

import signal

import rospy
from scenario import P, begin, mark, say

begin("ctrl_c_handler_default_sleep")
signal.signal(signal.SIGINT, signal.default_int_handler)
rospy.on_shutdown(lambda: say("hook"))
rate = rospy.Rate(1 / P)
try:
    while True:
        mark("pass")
        rate.sleep()
except KeyboardInterrupt:
    mark("caught")
    say("caught", rospy.is_shutdown())
