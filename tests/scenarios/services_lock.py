"""A handler and a timer share a lock: the one waits for the other."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark
from std_srvs.srv import Trigger

lock = threading.Lock()


def tick(event):
    with lock:
        mark("tick")
        block(1.6)


def handle(request):
    mark("asked")
    with lock:
        mark("handle")
        block(0.5)
    return True, ""


begin("services_lock")
rospy.Service("~a", Trigger, handle)
service = rospy.ServiceProxy("~a", Trigger)
rospy.Timer(rospy.Duration(3 * P), tick, oneshot=True)
block(3.5)
service()
mark("answered")
end_after(1)
