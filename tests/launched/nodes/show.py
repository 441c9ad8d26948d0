#!/usr/bin/env python3
"""Shows its arguments, and the values of the expressions ``~show``."""

import os
import sys

import common
import rospy
from std_msgs.msg import UInt32

NAMES = {"os": os, "sys": sys, "rospy": rospy, "UInt32": UInt32}

common.begin("show")
common.say(rospy.myargv()[1:])
for text in rospy.get_param("~show", []):
    common.say(text, "->", repr(eval(text, NAMES)))
