#!/usr/bin/env python3
"""Publishes 1, 2, 3 ... on ``chatter`` as soon as ``~listeners`` are connected, one each ``~period``."""

import common
import rospy
from std_msgs.msg import UInt32

common.begin("talker")
publisher = rospy.Publisher("chatter", UInt32, queue_size=10, latch=rospy.get_param("~latch", False))
common.wait_for(lambda: publisher.get_num_connections() >= rospy.get_param("~listeners", 1))
rate = rospy.Rate(1 / rospy.get_param("~period", 0.1))
for number in range(1, rospy.get_param("~count", 5) + 1):
    publisher.publish(number)
    rate.sleep()
common.say("done")
rospy.spin()
