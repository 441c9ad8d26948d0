"""sys.exit in the main with a number, after the hooks."""

import sys

import rospy
from scenario import begin

begin("exit_status")
rospy.on_shutdown(lambda: print("hook", flush=True))
sys.exit(int(rospy.myargv()[1]))
