"""Ctrl-C while the node serves, a handler of it is busy, and the main is in Service.spin()."""

import threading

import rospy
from scenario import attempt, begin, block, mark, say
from std_srvs.srv import Trigger


def handle(request):
    mark("begin")
    block(5.5)
    mark("finish")
    return True, "finished"


begin("ctrl_c_services_spin")
service = rospy.Service("~a", Trigger, handle)
names = {"proxy": rospy.ServiceProxy("~a", Trigger)}
threading.Thread(target=attempt, args=("proxy()", names), daemon=True).start()
service.spin()
say("spun")
