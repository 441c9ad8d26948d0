#!/usr/bin/env python3

import rospy


if __name__ == '__main__':
    rospy.init_node("sleeping_py_node")
    counter = 0
    while not rospy.is_shutdown():
        counter += 1
        rospy.loginfo("[SLEEPING PY NODE] counter = " + str(counter))

        # The work of the loop takes 5 ms
        rospy.sleep(0.005)

        # A whole period, whatever the work took
        rospy.sleep(0.1)
