#!/usr/bin/env python3

import rospy
from std_msgs.msg import UInt32


class PubsubPyNode:
    def __init__(self):
        # Start counting from zero
        self.counter = 0

        # Start the publisher
        self.publisher = rospy.Publisher("counter", UInt32, queue_size=10)

        # Start the subscriber
        rospy.Subscriber(
            "counter", UInt32, self.counterCallback, queue_size=10)

        # Start the timer, which uses the publisher
        timer_delta_t_in_seconds = 0.5
        rospy.Timer(
            rospy.Duration(timer_delta_t_in_seconds),
            self.timerCallback, oneshot=False)

    # Respond to the timer
    def timerCallback(self, event):
        self.counter += 1
        # Publish the current counter value
        self.publisher.publish(self.counter)

    # Respond to a message
    def counterCallback(self, message):
        # Display the counter value that has arrived
        rospy.loginfo("[PUBSUB PY NODE] counter = " + str(message.data))


if __name__ == '__main__':
    # Take ROS's own arguments (such as __ns:=/mrp); start the node
    rospy.init_node("pubsub_py_node")

    # Display the namespace of the node
    rospy.loginfo(
        "[PUBSUB PY NODE] namespace of node = " + rospy.get_namespace())

    # Start an instance of the class
    pubsub_py_node = PubsubPyNode()

    # Keep the process alive until shutdown
    rospy.spin()
