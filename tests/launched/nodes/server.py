#!/usr/bin/env python3
"""Answers ``answer``, which takes 0.3 s, and ends in the midst of ``end``, without a word to the master."""

import os
import time

import common
import rospy
from std_srvs.srv import SetBool, Trigger


def answer(request):
    time.sleep(0.3)
    return not request.data, request._connection_header["callerid"]


common.begin("server")
rospy.Service("answer", SetBool, answer)
rospy.Service("end", Trigger, lambda request: os._exit(5))
rospy.spin()
