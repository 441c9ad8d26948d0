"""A shutdown hook may still call the services of its node; what they take holds up the shutdown."""

import rospy
from scenario import attempt, begin, block, mark, say
from std_srvs.srv import Trigger


def handle(request):
    block(1)
    return True, f"{rospy.is_shutdown()}"


def hook():
    attempt("proxy().message", names)
    mark("hook")


begin("services_shutdown_hook")
rospy.Service("~a", Trigger, handle)
names = {"proxy": rospy.ServiceProxy("~a", Trigger)}
rospy.on_shutdown(hook)
block(1)
rospy.signal_shutdown("enough")
say(rospy.is_shutdown())
attempt("proxy().message", names)
