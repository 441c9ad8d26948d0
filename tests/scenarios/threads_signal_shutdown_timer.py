"""threading.Timer(3 * P, rospy.signal_shutdown, ...) ends spin; a rospy.Timer ticks until then."""

import threading

import rospy
from scenario import P, begin, mark, say

begin("threads_signal_shutdown_timer")
rospy.on_shutdown(lambda: mark("hook"))
rospy.Timer(rospy.Duration(0.8 * P), lambda event: mark("tick"))
threading.Timer(3 * P, rospy.signal_shutdown, ["time is up"]).start()
rospy.spin()
say("spin has returned", rospy.is_shutdown())
