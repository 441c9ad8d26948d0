#!/usr/bin/env python3

import sys

import rospy


class SpinnerPyNode:
    def __init__(self, frequency_in_hz):
        # Start counting from zero
        self.counter = 0

        # Start the timer, which takes a period
        timer_delta_t_in_seconds = 1.0 / frequency_in_hz
        rospy.Timer(
            rospy.Duration(timer_delta_t_in_seconds),
            self.timerCallback, oneshot=False)

    # Respond to the timer
    def timerCallback(self, event):
        self.counter += 1
        # Display the current counter value
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(self.counter))


if __name__ == '__main__':
    # Take ROS's own arguments (such as _frequency:=10); start the node
    rospy.init_node("spinner_py_node")

    # Read the private parameter; 2.0 if it is not set
    frequency_in_hz = rospy.get_param("~frequency", 2.0)

    # Refuse what no timer can do
    if frequency_in_hz <= 0:
        rospy.logfatal("[SPINNER PY NODE] frequency must be above 0")
        sys.exit(1)

    # Start an instance of the class
    spinner_py_node = SpinnerPyNode(frequency_in_hz)

    # Keep the process alive until shutdown
    rospy.spin()
