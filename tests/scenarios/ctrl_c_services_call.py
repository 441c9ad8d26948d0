"""Ctrl-C while a call waits: it keeps waiting until the handler has ended."""

import rospy
from scenario import attempt, begin, block, mark
from std_srvs.srv import Trigger


def handle(request):
    block(5.5)
    mark("finish")
    return True, "finished"


begin("ctrl_c_services_call")
rospy.Service("~a", Trigger, handle)
rospy.on_shutdown(lambda: mark("hook"))
attempt("proxy()", {"proxy": rospy.ServiceProxy("~a", Trigger)})
mark("answered")
