"""wait_for_service() looks every 0.3 s; with a timeout it gives up."""

import threading

import rospy
from scenario import P, attempt, begin, mark
from std_srvs.srv import Trigger

begin("services_wait_for_service")
names = {"P": P, "proxy": rospy.ServiceProxy("~a", Trigger)}
for text in (
    "rospy.wait_for_service('~a', P)",
    "rospy.wait_for_service('~a', timeout=2 * P)",
    "rospy.wait_for_service('~a', rospy.Duration(2.5 * P))",
    "rospy.wait_for_service('~a', -1)",
    "rospy.wait_for_service('~a', 0)",
    "rospy.wait_for_service('~a', 0.0)",
    "rospy.wait_for_service('~a', rospy.Duration(0))",
    "rospy.wait_for_service(5, P)",
    "rospy.wait_for_service('', P)",
    "rospy.wait_for_service(None, P)",
    "proxy.wait_for_service(P)",
    "proxy.wait_for_service(timeout=P)",
    "proxy.wait_for_service(0)",
):
    attempt(text, names)
    mark("waited")


def serve():
    rospy.Service("~a", Trigger, lambda request: (True, "here"))


threading.Timer(P, serve).start()
for text in (
    "rospy.wait_for_service('~a')",
    "rospy.wait_for_service('~a', P)",
    "proxy.wait_for_service()",
    "proxy().message",
):
    attempt(text, names)
    mark("there")
