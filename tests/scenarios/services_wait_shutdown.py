"""A shutdown while wait_for_service() waits: it raises when it looks again."""

import threading

import rospy
from scenario import P, begin, mark, say

begin("services_wait_shutdown")
threading.Timer(1.5 * P, rospy.signal_shutdown, ("enough",)).start()
for timeout in (None, 10 * P, P):
    try:
        rospy.wait_for_service("~a", timeout)
    except rospy.ROSException as error:
        say(type(error).__name__, error, rospy.is_shutdown())
    mark("interrupted")
