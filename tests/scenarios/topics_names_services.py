"""Services have names as all that ROS names: relative, private, global, remapped."""

import rospy
from scenario import attempt, begin, say
from std_srvs.srv import Trigger

begin("topics_names_services")
for name in ("services_a", "~a", "/topics_names_services/g/a", "services_b/", "services_old", "~private", "~a/b"):
    service = rospy.Service(name, Trigger, lambda request, name=name: (True, name))
    proxy = rospy.ServiceProxy(name, Trigger)
    say(name, service.resolved_name, proxy.resolved_name)
    attempt("proxy().message", {"proxy": proxy})
    attempt("rospy.wait_for_service(name, 1)", {"name": name})
for name in ("services_new", "/services_a", "topics_names_services/a", "/topics_names_services/a"):
    attempt("proxy().message", {"proxy": rospy.ServiceProxy(name, Trigger)})
