"""A response that cannot be sent: the caller is told; on a connection that persists, its beginning goes ahead of the next."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import SetBool


def handle(request):
    return (True, "fine") if request.data else (True, 5)


begin("services_broken_response")
rospy.Service("~a", SetBool, handle)
names = {"plain": rospy.ServiceProxy("~a", SetBool)}
for text in ("plain(True)", "plain(False)", "plain(True)"):
    attempt(text, names)
