#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class SubscriberPyNode(Node):
    def __init__(self):
        # Start the node
        super().__init__("subscriber_py_node")

        # Display the namespace of the node
        self.get_logger().info(
            "[SUBSCRIBER PY NODE] namespace of node = " + self.get_namespace())

        # Start the subscriber
        self.create_subscription(
            UInt32, "counter", self.counter_callback, 10)

    # Respond to a message
    def counter_callback(self, message):
        # Display the counter value that has arrived
        self.get_logger().info(
            "[SUBSCRIBER PY NODE] counter = " + str(message.data))


def main():
    # Take ROS's own arguments (such as -r __ns:=/mrp)
    rclpy.init()

    # Start an instance of the class
    subscriber_py_node = SubscriberPyNode()

    # Call the callbacks until shutdown
    try:
        rclpy.spin(subscriber_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
