"""Which lines are shown at which level, and their form."""

import rospy
from scenario import attempt

rospy.loginfo("before init_node")
rospy.logwarn("before %s", "init_node")
rospy.init_node("log_levels", log_level=getattr(rospy, rospy.myargv()[1]))
for name in ("logdebug", "loginfo", "logwarn", "logerr", "logfatal", "logout"):
    log = getattr(rospy, name)
    log("plain")
    log("%s and %d", "text", 5)
    log("100%")
    log("")
    log("two\nlines")
    log(None)
    log(3.5)
    log("named", logger_name="mine")
for text in ["rospy.loginfo()", "rospy.loginfo_once()", "rospy.loginfo_throttle(1)", "rospy.DEBUG", "rospy.FATAL"]:
    attempt(text)
print(rospy.INFO, rospy.WARN, rospy.ERROR)
