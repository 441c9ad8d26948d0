"""Sleeps and rates on a ROS time that a thread of the node publishes."""

import threading
import time

import rospy
from rosgraph_msgs.msg import Clock
from scenario import P, begin, say

rospy.set_param("/use_sim_time", True)
begin("topics_clock_sleep")
clock = rospy.Publisher("/clock", Clock, queue_size=1)


def tell():
    time.sleep(2 * P)
    for second in range(1, 12):
        clock.publish(rospy.Time(second))
        time.sleep(P)


threading.Thread(target=tell, daemon=True).start()
rospy.sleep(2)
say("slept", rospy.get_time())
rate = rospy.Rate(0.5)
for _ in range(3):
    rate.sleep()
    say("pass", rospy.get_time())
