#!/usr/bin/env python3

import rospy


if __name__ == '__main__':
    # Take ROS's own arguments (such as __ns:=/mrp); start the node
    rospy.init_node("plain_py_node")

    # Display the namespace of the node
    rospy.loginfo(
        "[PLAIN PY NODE] namespace of node = " + rospy.get_namespace())

    # Keep the process alive until shutdown
    rospy.spin()
