"""Service.spin() returns once the service or the node is shut down; it looks every 0.5 s."""

import threading

import rospy
from scenario import P, begin, mark, say
from std_srvs.srv import Trigger

begin("services_spin")
service = rospy.Service("~a", Trigger, lambda request: (True, ""))
threading.Timer(1.5 * P, service.shutdown).start()
service.spin()
mark("shut_down")
say(rospy.is_shutdown())
service.spin()
mark("at_once")
other = rospy.Service("~b", Trigger, lambda request: (True, ""))
threading.Timer(1.5 * P, rospy.signal_shutdown, ("enough",)).start()
other.spin()
mark("node_shut_down")
say(rospy.is_shutdown())
