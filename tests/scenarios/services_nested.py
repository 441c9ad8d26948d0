"""A handler calls another service, and even its own: each call has its thread."""

import rospy
from scenario import begin, block, mark, say
from std_srvs.srv import SetBool, Trigger

depth = []


def outer(request):
    mark("outer")
    answer = inner()
    return True, f"outer and {answer.message}"


def handle_inner(request):
    mark("inner")
    block(1)
    return True, "inner"


def handle_itself(request):
    depth.append(request.data)
    if len(depth) < 4:
        return itself(not request.data)
    return True, "".join("FT"[each] for each in depth)


begin("services_nested")
rospy.Service("~outer", Trigger, outer)
rospy.Service("~inner", Trigger, handle_inner)
rospy.Service("~itself", SetBool, handle_itself)
inner = rospy.ServiceProxy("~inner", Trigger)
itself = rospy.ServiceProxy("~itself", SetBool)
say(rospy.ServiceProxy("~outer", Trigger)().message)
mark("answered")
say(itself(True).message)
