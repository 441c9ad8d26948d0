#!/usr/bin/env python3
"""Counts how often it was started, and stays the third time."""

import sys

import common
import rospy

common.begin("again")
starts = rospy.get_param("~starts", 0) + 1
rospy.set_param("~starts", starts)
common.say("start", starts, common.used)
if starts < 3:
    sys.exit(starts - 1)
rospy.spin()
common.say("ended")
