"""A handler waits for a message that its caller would publish only after the call: Ctrl-C frees both."""

import rospy
from scenario import begin, mark, say
from std_msgs.msg import UInt32
from std_srvs.srv import Trigger


def handle(request):
    mark("asked")
    try:
        return True, str(rospy.wait_for_message("~a", UInt32))
    finally:
        mark("freed")


begin("ctrl_c_services_deadlock_message")
publisher = rospy.Publisher("~a", UInt32, queue_size=1)
rospy.Service("~next", Trigger, handle)
try:
    say(rospy.ServiceProxy("~next", Trigger)())
    publisher.publish(1)
except rospy.ServiceException as error:
    say(type(error).__name__, error)
