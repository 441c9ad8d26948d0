"""Ctrl-C while a call waits, in a node that handles its signals itself: a KeyboardInterrupt."""

import rospy
from scenario import begin, block, mark
from std_srvs.srv import Trigger


def handle(request):
    block(5.5)
    mark("finish")
    return True, "finished"


begin("ctrl_c_services_call_no_signals", disable_signals=True)
rospy.Service("~a", Trigger, handle)
proxy = rospy.ServiceProxy("~a", Trigger)
try:
    proxy()
except KeyboardInterrupt:
    mark("interrupted")
block(3)
