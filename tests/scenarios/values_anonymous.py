"""An anonymous node's name."""

import os
import re

import rospy

rospy.init_node("values_anonymous", anonymous=True)
print(re.sub(r"_\d+", "_N", rospy.get_name()))
print(str(os.getpid()) in rospy.get_name())
