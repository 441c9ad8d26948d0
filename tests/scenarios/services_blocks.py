"""A call blocks its caller until the answer is there; timers and other callers continue."""

import rospy
from scenario import P, begin, block, end_after, mark, say
from std_srvs.srv import Trigger


def handle(request):
    block(2.5)
    return True, "at last"


begin("services_blocks")
rospy.Service("~slow", Trigger, handle)
rospy.Service("~quick", Trigger, lambda request: (True, ""))
slow, quick = rospy.ServiceProxy("~slow", Trigger), rospy.ServiceProxy("~quick", Trigger)


def call_quick(event):
    quick()
    mark("quick")


timers = [
    rospy.Timer(rospy.Duration(P), lambda event: mark("tick")),
    rospy.Timer(rospy.Duration(1.4 * P), call_quick),
]
say(slow().message)
mark("slow")
say(slow().message)
mark("slow")
for timer in timers:
    timer.shutdown()
end_after(2)
