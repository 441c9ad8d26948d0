"""Calls to a service that is not there, or not yet, or no more."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import Trigger

begin("services_unavailable")
names = {"proxy": rospy.ServiceProxy("~a", Trigger), "other": rospy.ServiceProxy("/services_nowhere", Trigger)}
attempt("proxy().message", names)
attempt("other()", names)
attempt("proxy(1)", names)
service = rospy.Service("~a", Trigger, lambda request: (True, "here"))
attempt("proxy().message", names)
service.shutdown()
attempt("proxy().message", names)
again = rospy.Service("~a", Trigger, lambda request: (True, "here again"))
attempt("proxy().message", names)
rospy.signal_shutdown("enough")
attempt("proxy().message", names)
