"""After the shutdown spin returns at once, and Rate still paces."""

import rospy
from scenario import P, begin, mark, now

begin("spin_after_shutdown")
rospy.signal_shutdown("at once")
start = now()
rospy.spin()
mark("spin", now() - start)
rate = rospy.Rate(1 / P)
for _ in range(2):
    rate.sleep()
    mark("slept", now() - start)
rospy.sleep(P)
mark("slept", now() - start)
rospy.Timer(rospy.Duration(P), print).join()
mark("joined", now() - start)
