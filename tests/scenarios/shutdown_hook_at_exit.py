"""The hooks of a node whose main just ends run as well."""

import rospy
from scenario import begin

begin("shutdown_hook_at_exit")
rospy.on_shutdown(lambda: print("hook", rospy.is_shutdown(), flush=True))
print("the main ends", flush=True)
