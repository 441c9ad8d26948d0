#!/usr/bin/env python3
"""Waits for one message and ends."""

import common
import rospy
from std_msgs.msg import UInt32

common.begin("once")
common.say(rospy.wait_for_message("chatter", UInt32).data > 0)
