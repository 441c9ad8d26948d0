"""A negative rate never sleeps."""

import rospy
from scenario import begin, mark

begin("rate_negative")
rate = rospy.Rate(-2)
print("sleep_dur", rate.sleep_dur)
for _ in range(3):
    rate.sleep()
    mark("pass")
