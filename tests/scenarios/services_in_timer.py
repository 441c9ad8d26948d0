"""A timer's callback calls a service of the same node: each has a thread, so nothing hangs."""

import rospy
from scenario import P, begin, block, end_after, mark
from std_srvs.srv import Trigger


def handle(request):
    mark("handle")
    block(0.5)
    return True, ""


def tick(event):
    mark("tick")
    service()
    mark("answered")


begin("services_in_timer")
rospy.Service("~a", Trigger, handle)
service = rospy.ServiceProxy("~a", Trigger)
timer = rospy.Timer(rospy.Duration(P), tick)
block(3.75)
timer.shutdown()
end_after(1)
