"""The main ends without spin(): rospy's threads are daemons, so a service ends with it."""

import threading

import rospy
from scenario import attempt, begin, block, mark
from std_srvs.srv import Trigger


def handle(request):
    mark("handle")
    block(3)
    mark("never")
    return True, ""


begin("services_in_thread_only")
rospy.Service("~a", Trigger, handle)
names = {"proxy": rospy.ServiceProxy("~a", Trigger)}
threading.Thread(target=attempt, args=("proxy()", names), daemon=True).start()
block(1)
mark("last")
