#!/usr/bin/env python3
"""Tells of its end on ``chatter``, to whoever is still there."""

import common
import rospy
from std_msgs.msg import String

common.begin("hooks")
publisher = rospy.Publisher("last_words", String, queue_size=10)
rospy.Subscriber("last_words", String, lambda message: None)
rospy.on_shutdown(lambda: common.say("first hook", rospy.is_shutdown()))
rospy.on_shutdown(lambda: (publisher.publish("end"), common.say("second hook")))
common.meet(rospy.get_param("/nodes"))
common.say("spins")
rospy.spin()
common.say("after spin", rospy.is_shutdown())
