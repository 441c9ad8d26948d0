"""A ROSInterruptException that is not caught."""

import rospy

rospy.init_node("main_interrupted")
raise rospy.ROSInterruptException("nobody catches it")
