"""Service.shutdown() takes the service away; what runs continues, and the name is free again."""

import threading

import rospy
from scenario import attempt, begin, block, mark, say
from std_srvs.srv import Trigger


def handle(request):
    mark("begin")
    block(2)
    return True, "finished"


begin("services_shutdown")
service = rospy.Service("~a", Trigger, handle)
proxy = rospy.ServiceProxy("~a", Trigger)
names = {"proxy": proxy, "service": service}
thread = threading.Thread(target=attempt, args=("proxy().message", names))
thread.start()
block(1)
attempt("service.shutdown('enough')", names)
attempt("proxy().message", names)
attempt("rospy.wait_for_service('~a', 0.2)", names)
thread.join()
mark("joined")
attempt("service.shutdown()", names)
service = rospy.Service("~a", Trigger, lambda request: (True, "another"))
attempt("proxy().message", names)
attempt("service.shutdown()", names)  # the first one's
attempt("proxy().message", names)
say(rospy.is_shutdown())
