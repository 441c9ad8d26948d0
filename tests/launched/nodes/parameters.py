#!/usr/bin/env python3
"""Shows parameters: the names are its arguments."""

import common
import rospy

common.begin("parameters")
for name in rospy.myargv()[1:]:
    value = rospy.get_param(name, None)
    common.say(name, type(value).__name__, sorted(value.items()) if isinstance(value, dict) else repr(value))
