"""A node that publishes /clock and lives by it: ROS time runs at half the speed."""

import time

import rospy
from rosgraph_msgs.msg import Clock
from scenario import P, begin, say

rospy.set_param("/use_sim_time", True)
begin("topics_clock")
say("at first", rospy.Time.now().to_sec())
clock = rospy.Publisher("/clock", Clock, queue_size=1)
time.sleep(2 * P)
rospy.Timer(rospy.Duration(2), lambda event: say("tick", event.current_expected.secs, event.current_real.secs))
for second in range(1, 10):
    clock.publish(rospy.Time(second))
    time.sleep(P)
    say("now", rospy.get_time())
