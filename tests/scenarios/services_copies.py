"""What a handler keeps or changes is its own: requests and responses are copies, within one node, too."""

import rospy
from scenario import begin, say
from std_srvs.srv import SetBool, SetBoolRequest, SetBoolResponse

kept = []
response = SetBoolResponse(True, "the first")


def handle(request):
    kept.append(request)
    request.data = not request.data
    return response


begin("services_copies")
rospy.Service("~a", SetBool, handle)
service = rospy.ServiceProxy("~a", SetBool)
request = SetBoolRequest(True)
first = service(request)
response.message = "the second"
second = service(request)
say(request.data, [each.data for each in kept], any(each is request for each in kept))
say(first.message, second.message, first is second, second is response)
