#!/usr/bin/env python3
"""Sends five messages to a slow listener, and is gone at once."""

import os
import time

import common
import rospy
from std_msgs.msg import UInt32

common.begin("sender")
publisher = rospy.Publisher("chatter", UInt32, queue_size=10)
common.wait_for(publisher.get_num_connections)
for number in range(5):
    publisher.publish(number)
    time.sleep(0.05)
common.say("is gone")
os._exit(0)
