"""A proxy of another type than the service's is refused."""

import rospy
from nav_msgs.srv import LoadMap
from scenario import attempt, begin, block, say
from std_srvs.srv import Empty, SetBool, Trigger


def call(proxy, *args):
    try:
        say(proxy(*args))
    except rospy.ServiceException as error:
        block(0.5)  # its node has time to warn
        say(type(error).__name__, error)


begin("services_mismatch")
rospy.Service("~a", SetBool, lambda request: (True, ""))
trigger = rospy.ServiceProxy("~a", Trigger)
empty = rospy.ServiceProxy("~a", Empty, persistent=True)
call(trigger)
call(empty)
call(empty)
call(rospy.ServiceProxy("~a", LoadMap), "a map")
call(rospy.ServiceProxy("~a", SetBool), True)
attempt("trigger.wait_for_service(1)", {"trigger": trigger})
