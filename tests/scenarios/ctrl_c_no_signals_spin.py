"""With disable_signals spin takes a Ctrl-C itself, and shuts down."""

import rospy
from scenario import begin

begin("ctrl_c_no_signals_spin", disable_signals=True)
rospy.on_shutdown(lambda: print("hook", flush=True))
rospy.spin()
print("spin has returned", rospy.is_shutdown(), flush=True)
