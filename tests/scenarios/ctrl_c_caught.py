"""A handler of KeyboardInterrupt sees nothing of a Ctrl-C: rospy has taken the signal."""

import time

import rospy
from scenario import P, begin, mark

begin("ctrl_c_caught")
try:
    time.sleep(7.5 * P)
    print("slept on", rospy.is_shutdown(), flush=True)
except KeyboardInterrupt:
    print("caught", rospy.is_shutdown(), flush=True)
mark("end")
