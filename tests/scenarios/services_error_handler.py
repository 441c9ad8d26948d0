"""An error_handler is called instead of the log, with what was raised; one that raises breaks the call."""

import rospy
from scenario import attempt, begin, block, say
from std_srvs.srv import Trigger


def fail(request):
    raise ValueError("no value")


def handle(error, kind, value, trace):
    say("handle", repr(error), kind.__name__, value is error, trace is error.__traceback__)


def handle_badly(error, kind, value, trace):
    raise RuntimeError("in the error handler")


def refuse(request):
    raise rospy.ServiceException("refused")


begin("services_error_handler")
rospy.Service("~a", Trigger, fail, error_handler=handle)
rospy.Service("~b", Trigger, fail, error_handler=handle_badly)
rospy.Service("~c", Trigger, refuse, error_handler=handle)
rospy.Service("~d", Trigger, fail, 1000, handle)
for name in "abcd":
    attempt("proxy()", {"proxy": rospy.ServiceProxy(f"~{name}", Trigger)})
    block(0.5)
