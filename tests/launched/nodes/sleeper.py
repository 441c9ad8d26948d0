#!/usr/bin/env python3
"""Sleeps on the time that it is told."""

import common
import rospy

common.begin("sleeper")
common.meet(2)
common.wait_for(lambda: rospy.get_time() >= 100)
for _ in range(3):
    before = rospy.get_time()
    rospy.sleep(5)
    common.say("slept", 5 <= rospy.get_time() - before <= 7)
rospy.spin()
