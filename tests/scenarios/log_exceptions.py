"""A log line with a wrong number of arguments, or with an exception."""

import rospy

rospy.init_node("log_exceptions")
try:
    1 / 0
except ZeroDivisionError:
    rospy.logerr("failed", exc_info=True)
rospy.loginfo("after")
