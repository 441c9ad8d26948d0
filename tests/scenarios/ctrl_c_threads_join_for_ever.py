"""A thread that never looks at is_shutdown keeps the node from ending after Ctrl-C: it must be killed."""

import threading

import rospy
from scenario import P, begin, say


def loop():
    while True:
        rospy.sleep(P)


begin("ctrl_c_threads_join_for_ever")
threading.Thread(target=loop).start()
rospy.spin()
say("spin has returned")
