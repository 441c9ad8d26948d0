"""A ServiceException that is not caught ends the main."""

import rospy
from scenario import begin
from std_srvs.srv import Trigger


def refuse(request):
    raise rospy.ServiceException("not now")


begin("services_uncaught")
rospy.Service("~a", Trigger, refuse)
rospy.ServiceProxy("~a", Trigger)()
