"""What log_throttle, log_throttle_identical and log_once let through, by call site."""

import rospy
from scenario import P, begin, mark, now

begin("throttle")
rate = rospy.Rate(1 / P)
number = 0
while now() < 9.25 * P:
    number += 1
    mark("pass")
    rospy.loginfo_throttle(2.5 * P, "throttled %d", number)
    rospy.logwarn_throttle(3.5 * P, f"throttled warning {number}")
    rospy.loginfo_throttle_identical(2.5 * P, "identical")
    rospy.loginfo_throttle_identical(2.5 * P, f"identical {number // 3}")
    rospy.loginfo_once("once %d", number)
    rospy.logerr_once("once")
    for line in "ab":
        rospy.loginfo_throttle(3.5 * P, "in a loop: " + line)
    rate.sleep()
mark("end")
