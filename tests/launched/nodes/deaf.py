#!/usr/bin/env python3
"""Does not heed the signals that its arguments name."""

import signal
import time

import common
import rospy

common.begin("deaf", disable_signals=True)
for name in rospy.myargv()[1:]:
    signal.signal(getattr(signal, name), lambda number, frame: common.say("does not heed", number))
common.say("goes on")
while True:
    time.sleep(1)
