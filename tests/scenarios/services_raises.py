"""A handler that raises: its node logs the error, and the caller is told. A ServiceException is only told."""

import rospy
from scenario import attempt, begin, say
from std_srvs.srv import Trigger


def fail(kind, *args):
    raise kind(*args)


def nested(request):
    return fail(ZeroDivisionError, "deep down")


def caught(request):
    try:
        fail(KeyError, "key")
    except KeyError:
        fail(RuntimeError, "while handling")


HANDLERS = {
    "value": lambda request: fail(ValueError, "no value"),
    "nothing": lambda request: fail(ValueError),
    "service": lambda request: fail(rospy.ServiceException, "refused"),
    "ros": lambda request: fail(rospy.ROSException, "of ROS"),
    "interrupt": lambda request: fail(rospy.ROSInterruptException, "interrupted"),
    "accent": lambda request: fail(ValueError, "naïve"),
    "nested": nested,
    "caught": caught,
    "arguments": lambda: None,
}

begin("services_raises")
for name, handler in HANDLERS.items():
    rospy.Service(f"~{name}", Trigger, handler)
    attempt(name + "()", {name: rospy.ServiceProxy(f"~{name}", Trigger)})
say("the node goes on", rospy.is_shutdown())
