"""A node that shuts down while one of its services works: the handler ends its work, and the caller is told nothing."""

import threading

import rospy
from scenario import P, attempt, begin, block, mark
from std_srvs.srv import Trigger


def handle(request):
    mark("begin")
    block(2.5)
    mark("finish")
    return True, "finished"


begin("services_shutdown_in_call")
rospy.Service("~a", Trigger, handle)
rospy.on_shutdown(lambda: mark("hook"))
threading.Timer(P, rospy.signal_shutdown, ("enough",)).start()
names = {"proxy": rospy.ServiceProxy("~a", Trigger)}
attempt("proxy()", names)
mark("answered")
attempt("proxy()", names)
