#!/usr/bin/env python3
"""Sets parameters that others wait for, and waits for theirs."""

import common
import rospy

common.begin("writer")
rospy.set_param("~own", rospy.get_name())
rospy.set_param("/all" + rospy.get_name(), {"number": len(rospy.get_name())})
common.wait_for(lambda: len(rospy.get_param("/all")) == 2)
common.say(sorted(rospy.get_param("/all").items()), rospy.search_param("own"), rospy.has_param("~other"))
rospy.spin()
