"""An error_handler is called instead of the log, with what was raised."""

import rospy
from scenario import attempt, begin, say
from std_srvs.srv import Trigger


def fail(request):
    raise ValueError("no value")


def handle(error, kind, value, trace):
    say("handle", repr(error), kind.__name__, value is error, trace is error.__traceback__)


def refuse(request):
    raise rospy.ServiceException("refused")


begin("services_error_handler")
rospy.Service("~a", Trigger, fail, error_handler=handle)
rospy.Service("~b", Trigger, refuse, error_handler=handle)
rospy.Service("~c", Trigger, fail, 1000, handle)
for name in "abc":
    attempt("proxy()", {"proxy": rospy.ServiceProxy(f"~{name}", Trigger)})
