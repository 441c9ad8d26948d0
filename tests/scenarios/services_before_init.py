"""Before init_node() a service can be made, but it is not found; its name is that which it would have then."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import Trigger

names = {"Trigger": Trigger}
names["service"] = rospy.Service("services_before_init/a", Trigger, lambda request: (True, "early"))
names["proxy"] = rospy.ServiceProxy("services_before_init/a", Trigger)
attempt("service.resolved_name", names)
attempt("proxy()", names)
attempt("rospy.Service('~a', Trigger, print).resolved_name", names)
attempt("rospy.ServiceProxy('~a', Trigger).resolved_name", names)
attempt("rospy.wait_for_service('services_before_init/a', 0.1)", names)
begin("services_before_init")
attempt("rospy.wait_for_service('services_before_init/a', 2)", names)
attempt("proxy()", names)
