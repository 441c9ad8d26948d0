"""default_int_handler put back after init_node: Ctrl-C is a KeyboardInterrupt, for which spin shuts the node down."""

import signal

import rospy
from scenario import begin, say

begin("ctrl_c_handler_default")
signal.signal(signal.SIGINT, signal.default_int_handler)
rospy.on_shutdown(lambda: say("hook"))
rospy.spin()
say("spin has returned", rospy.is_shutdown())
