"""The exceptions of services: their place among Python's and rospy's."""

from scenario import attempt, begin
from std_srvs.srv import Trigger

begin("services_exceptions")
for text in (
    "rospy.ServiceException.__mro__",
    "issubclass(rospy.ServiceException, rospy.ROSException)",
    "str(rospy.ServiceException('text'))",
    "rospy.service.ServiceException is rospy.ServiceException",
    "rospy.ServiceProxy('~a', Trigger).wait_for_service(0.1)",
    "Trigger._type",
    "Trigger._md5sum",
    "Trigger._request_class.__name__",
    "Trigger._response_class.__name__",
    "Trigger._request_class._type",
    "Trigger()",
    "callable(rospy.ServiceProxy('~a', Trigger))",
):
    attempt(text, {"Trigger": Trigger})
