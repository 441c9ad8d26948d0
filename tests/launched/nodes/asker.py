#!/usr/bin/env python3
"""Asks which of two providers answers, before and after the later one has shut its service down."""

import common
import rospy
from std_srvs.srv import Trigger

common.begin("asker")
who = rospy.ServiceProxy("who", Trigger)
common.wait_for(lambda: rospy.has_param("/first/ready") and rospy.has_param("/second/ready"))
common.say(who().message)
rospy.set_param("/asked", True)
common.wait_for(lambda: rospy.has_param("/shut"))
try:
    common.say(who().message)
except rospy.ServiceException as error:
    common.say(error)
rospy.spin()
