"""sys.exit in the main with a text."""

import sys

import rospy

rospy.init_node("exit_message")
rospy.on_shutdown(lambda: print("hook", flush=True))
sys.exit("that is all")
