#!/usr/bin/env python3

import threading

import rospy


class OdometerPyNode:
    def __init__(self):
        # Turns of the wheels: always a pair
        self.left = 0
        self.right = 0
        # Whoever touches them holds this lock
        self.lock = threading.Lock()
        rospy.Timer(rospy.Duration(0.5), self.readCallback)
        rospy.Timer(rospy.Duration(0.6), self.reportCallback)

    # Read both wheels, one after the other
    def readCallback(self, event):
        with self.lock:
            self.left += 1
            rospy.sleep(0.25)  # the sensor is slow
            self.right += 1

    # Report both wheels
    def reportCallback(self, event):
        with self.lock:
            rospy.loginfo(
                "[WHEELS] left = %d, right = %d",
                self.left, self.right)


if __name__ == '__main__':
    rospy.init_node("odometer_py_node")
    odometer_py_node = OdometerPyNode()
    rospy.spin()
