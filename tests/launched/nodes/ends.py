#!/usr/bin/env python3
"""Ends in the way that its argument says."""

import atexit
import os
import signal
import sys
import time

import common
import rospy

how, *rest = rospy.myargv()[1:]
common.begin("ends")
rospy.on_shutdown(lambda: common.say("hook"))
atexit.register(lambda: common.say("at exit"))
time.sleep(float(rest[0]) if rest else 0)
common.say(how)
if how == "exit":
    sys.exit(int(rest[1]))
elif how == "at_once":
    os._exit(4)
elif how == "raise":
    raise ValueError("as it was told")
elif how == "term":
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(5)
elif how == "thread":
    rospy.Timer(rospy.Duration(0.2), lambda event: os._exit(6))
    rospy.spin()
elif how == "shutdown":
    rospy.signal_shutdown("as it was told")
