"""disable_rostime: the node stays on its own clock, whatever use_sim_time says."""

import rospy
from scenario import P, begin, say

rospy.set_param("/use_sim_time", True)
begin("topics_clock_disabled", disable_rostime=True)
say(rospy.rostime.is_wallclock())
rospy.sleep(P)
say("slept")
