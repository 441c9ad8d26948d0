"""A handler with a Rate of its own, as of something that takes a few steps."""

import rospy
from scenario import P, begin, mark, say
from std_srvs.srv import Trigger


def handle(request):
    rate = rospy.Rate(1 / P)
    for _ in range(3):
        mark("step")
        rate.sleep()
    return True, "three steps"


begin("services_rate")
rospy.Service("~a", Trigger, handle)
service = rospy.ServiceProxy("~a", Trigger)
rate = rospy.Rate(0.5 / P)
for _ in range(2):
    mark("call")
    say(service().message)
    rate.sleep()
mark("done")
