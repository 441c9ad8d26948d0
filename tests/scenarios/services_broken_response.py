"""A response that cannot be sent is an error of the handler's."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import SetBool


def handle(request):
    return (True, "fine") if request.data else (True, 5)


begin("services_broken_response")
rospy.Service("~a", SetBool, handle)
names = {"plain": rospy.ServiceProxy("~a", SetBool), "keeps": rospy.ServiceProxy("~a", SetBool, persistent=True)}
for text in ("plain(True)", "plain(False)", "plain(True)"):
    attempt(text, names)
for text in ("keeps(True)", "keeps(False)", "keeps(True)", "keeps(True)", "keeps(True)"):
    attempt(text, names)
