#!/usr/bin/env python3
"""Draws random numbers from its own seed, beside others that do."""

import random
import sys
import time

import common
import rospy

common.begin("drawer")
common.meet(2)
random.seed(1)
for _ in range(3):
    common.say(common.used, random.randrange(1000), sys.modules["__main__"].__doc__[:5])
    time.sleep(0.2)
rospy.spin()
