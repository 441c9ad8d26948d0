#!/usr/bin/env python3

import rospy
from std_msgs.msg import UInt32


class SubscriberPyNode:
    def __init__(self):
        # Start the subscriber
        rospy.Subscriber(
            "counter", UInt32, self.counterCallback, queue_size=10)

    # Respond to a message
    def counterCallback(self, message):
        # Display the counter value that has arrived
        rospy.loginfo("[SUBSCRIBER PY NODE] counter = " + str(message.data))


if __name__ == '__main__':
    # Take ROS's own arguments (such as __ns:=/mrp); start the node
    rospy.init_node("subscriber_py_node")

    # Display the namespace of the node
    rospy.loginfo(
        "[SUBSCRIBER PY NODE] namespace of node = " + rospy.get_namespace())

    # Start an instance of the class
    subscriber_py_node = SubscriberPyNode()

    # Keep the process alive until shutdown
    rospy.spin()
