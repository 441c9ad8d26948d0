"""What the handler logs, and what rospy logs of it."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import Trigger


def handle(request):
    rospy.loginfo("asked")
    rospy.logwarn("hm")
    return None


begin("services_log", log_level=rospy.ERROR)
rospy.Service("~a", Trigger, handle)
rospy.Service("~b", Trigger, lambda request: {}["nothing"])
names = {"a": rospy.ServiceProxy("~a", Trigger), "b": rospy.ServiceProxy("~b", Trigger)}
attempt("a()", names)
attempt("b()", names)
