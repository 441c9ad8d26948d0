"""A node of a student: an Event lets the motor loop run, a timer stops it and another one restarts it."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark

released = threading.Event()


def drive():
    rate = rospy.Rate(1 / P)
    while not rospy.is_shutdown():
        released.wait()
        mark("drive")
        rate.sleep()


begin("threads_node_emergency_stop")
released.set()
threading.Thread(target=drive, daemon=True).start()
rospy.Timer(rospy.Duration(2.5 * P), lambda event: released.clear(), oneshot=True)
rospy.Timer(rospy.Duration(4.5 * P), lambda event: released.set(), oneshot=True)
block(0.5)
end_after(6)
