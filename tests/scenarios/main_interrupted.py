"""A ROSInterruptException that nobody catches."""

import rospy

rospy.init_node("main_interrupted")
raise rospy.ROSInterruptException("nobody catches it")
