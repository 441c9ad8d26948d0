#!/usr/bin/env python3

import rospy


class SpinnerPyNode:
    def __init__(self):
        # Start counting from zero
        self.counter = 0


if __name__ == '__main__':
    # Take ROS's own arguments (such as __ns:=/mrp); start the node
    rospy.init_node("spinner_py_node")

    # Display the namespace of the node
    rospy.loginfo(
        "[SPINNER PY NODE] namespace of node = " + rospy.get_namespace())

    # Start an instance of the class
    spinner_py_node = SpinnerPyNode()

    # Keep the process alive until shutdown
    rospy.spin()
