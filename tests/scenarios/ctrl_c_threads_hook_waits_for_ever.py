"""A shutdown hook that joins a thread which waits for is_shutdown: neither comes, the node must be killed."""

import threading

import rospy
from scenario import P, begin, say


def loop():
    while not rospy.is_shutdown():
        rospy.sleep(P)


begin("ctrl_c_threads_hook_waits_for_ever")
worker = threading.Thread(target=loop)
worker.start()
rospy.on_shutdown(worker.join)
rospy.spin()
say("never")
