"""The threads of services: their handlers run in daemons that end with the call."""

import threading

import rospy
from scenario import begin, block, say
from std_srvs.srv import Trigger


def handle(request):
    thread = threading.current_thread()
    say(thread is threading.main_thread(), thread.daemon)
    return True, ""


begin("services_threads")
before = threading.active_count()
rospy.Service("~a", Trigger, handle)
rospy.ServiceProxy("~a", Trigger)()
block(0.5)
keeps = rospy.ServiceProxy("~a", Trigger, persistent=True)
keeps()
block(0.5)
one = threading.active_count()
keeps.close()
block(0.5)
say(one - threading.active_count())
