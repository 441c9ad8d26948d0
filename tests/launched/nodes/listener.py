#!/usr/bin/env python3
"""Tells what it hears on ``chatter``, and takes ``~takes`` seconds for each."""

import time

import common
import rospy
from std_msgs.msg import UInt32


def hear(message):
    common.say("hears", message.data)
    time.sleep(rospy.get_param("~takes", 0))
    if rospy.get_param("~takes", 0):
        common.say("has heard", message.data)


common.begin("listener")
rospy.Subscriber("chatter", UInt32, hear, queue_size=rospy.get_param("~queue_size", None))
rospy.spin()
