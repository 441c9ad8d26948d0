"""The caller holds a lock that the handler needs: the main never wakes, and the node must be killed."""

import threading

import rospy
from scenario import begin, mark, say
from std_srvs.srv import Trigger

lock = threading.Lock()


def handle(request):
    mark("asked")
    with lock:
        return True, "never"


begin("ctrl_c_services_deadlock_lock")
rospy.on_shutdown(lambda: mark("hook"))
rospy.Service("~a", Trigger, handle)
service = rospy.ServiceProxy("~a", Trigger)
with lock:
    say(service())
