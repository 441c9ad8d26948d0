#!/usr/bin/env python3
"""Tells a time that goes ten times as fast, once the other node has met it."""

import time

import common
import rospy
from rosgraph_msgs.msg import Clock

common.begin("clock", disable_rostime=True)
publisher = rospy.Publisher("/clock", Clock, queue_size=10)
common.wait_for(publisher.get_num_connections)
common.meet(2)
for number in range(31):
    publisher.publish(rospy.Time(100 + number))
    time.sleep(0.1)
common.say("done")
rospy.spin()
