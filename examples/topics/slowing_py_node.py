#!/usr/bin/env python3

import rospy
from std_msgs.msg import UInt32


# Publish at 10 Hz for 20 s, and from then on at 2 Hz
if __name__ == '__main__':
    rospy.init_node("slowing_py_node")
    publisher = rospy.Publisher("counter", UInt32, queue_size=10)
    counter = 0
    for frequency, number in ((10, 200), (2, 1000)):
        rate = rospy.Rate(frequency)
        for _ in range(number):
            if rospy.is_shutdown():
                break
            counter += 1
            publisher.publish(counter)
            rate.sleep()
