"""A node has one service of a name; the first stays."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import SetBool, Trigger

begin("services_same_name")
names = {
    **{"Trigger": Trigger, "SetBool": SetBool},
    "first": rospy.Service("~a", Trigger, lambda request: (True, "first")),
    "proxy": rospy.ServiceProxy("~a", Trigger),
}
attempt("rospy.Service('~a', Trigger, lambda request: (True, 'second'))", names)
attempt("proxy()", names)
attempt("rospy.Service('~a', SetBool, print)", names)
attempt("proxy()", names)
attempt("first.shutdown()", names)
attempt("type(rospy.Service('~a', Trigger, lambda request: (True, 'third'))).__name__", names)
attempt("proxy()", names)
