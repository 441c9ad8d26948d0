"""A SIGINT handler that only sets a flag: the Rate loop in the main ends after its sleep, and hooks run at the end."""

import signal

import rospy
from scenario import P, begin, mark, say

stopped = []
begin("ctrl_c_handler_in_loop")
signal.signal(signal.SIGINT, lambda number, frame: stopped.append(number))
rospy.on_shutdown(lambda: say("hook"))
rate = rospy.Rate(1 / P)
while not stopped:
    mark("pass")
    rate.sleep()
say("the loop has ended", rospy.is_shutdown())
