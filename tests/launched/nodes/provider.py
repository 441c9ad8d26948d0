#!/usr/bin/env python3
"""Has a service that another node has, too: the master knows the later one, which shuts it down once it was asked."""

import common
import rospy
from std_srvs.srv import Trigger

common.begin("provider")
if later := rospy.get_param("~later", False):
    rospy.wait_for_service("who")
service = rospy.Service("who", Trigger, lambda request: (True, rospy.get_name()))
rospy.set_param("~ready", True)
if later:
    common.wait_for(lambda: rospy.has_param("/asked"))
    service.shutdown()
    rospy.set_param("/shut", True)
rospy.spin()
