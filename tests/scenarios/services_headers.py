"""What the headers of the connection tell the handler and the caller."""

import rospy
from scenario import begin, say
from std_srvs.srv import Trigger


def handle(request):
    say(sorted(request._connection_header.items()))
    return True, ""


begin("services_headers")
rospy.Service("~a", Trigger, handle)
for proxy in (
    rospy.ServiceProxy("~a", Trigger),
    rospy.ServiceProxy("~a", Trigger, persistent=True),
    rospy.ServiceProxy("~a", Trigger, headers={"cookie": "1", "callerid": "/somebody"}),
    rospy.ServiceProxy("~a", Trigger, True, {"cookie": "2"}),
):
    say(sorted(proxy()._connection_header.items()))
