#!/usr/bin/env python3
"""Listens for another type than is published."""

import common
import rospy
from std_msgs.msg import String

common.begin("string_listener")
rospy.Subscriber("chatter", String, lambda message: common.say("hears", message.data))
rospy.spin()
