#!/usr/bin/env python3

import rospy


if __name__ == '__main__':
    # Take ROS's own arguments (such as __ns:=/mrp); start the node
    rospy.init_node("spinner_py_node")

    # Display the namespace of the node
    rospy.loginfo(
        "[SPINNER PY NODE] namespace of node = " + rospy.get_namespace())

    # Set the rate of the loop
    loop_frequency_in_hz = 2.0
    loop_rate = rospy.Rate(loop_frequency_in_hz)

    # Start counting from zero
    counter = 0

    # Loop until shutdown
    while not rospy.is_shutdown():
        counter += 1
        # Display the current counter value
        rospy.loginfo("[SPINNER PY NODE] counter = " + str(counter))

        # Sleep for what is left of this period
        loop_rate.sleep()
