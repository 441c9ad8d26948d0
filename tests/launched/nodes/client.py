#!/usr/bin/env python3
"""Calls the services of ``server.py``; with ``~last``, also that one with which its node ends."""

import time

import common
import rospy
from std_srvs.srv import SetBool, Trigger


def call(proxy, *args):
    try:
        common.say(str(proxy(*args)).replace("\n", ", "))
    except rospy.ServiceException as error:
        common.say(error)


common.begin("client")
answer, end = rospy.ServiceProxy("answer", SetBool), rospy.ServiceProxy("end", Trigger)
rospy.wait_for_service("end")
common.say(answer.resolved_name)
for data in (True, False):
    call(answer, data)
common.meet(2)
if rospy.get_param("~last", False):
    keeps = rospy.ServiceProxy("answer", SetBool, persistent=True)
    call(keeps, True)
    call(end)
    time.sleep(0.3)  # the process has ended
    for proxy, *args in ((end,), (keeps, True), (answer, True)):
        call(proxy, *args)
    try:
        rospy.wait_for_service("end", 0.8)
    except rospy.ROSException as error:
        common.say(error)
common.say("done")
rospy.spin()
