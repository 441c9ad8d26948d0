#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class PublisherPyNode(Node):
    def __init__(self):
        # Start the node
        super().__init__("publisher_py_node")

        # Display the namespace of the node
        self.get_logger().info(
            "[PUBLISHER PY NODE] namespace of node = " + self.get_namespace())

        # Start counting from zero
        self.counter = 0

        # Start the publisher
        self.publisher = self.create_publisher(UInt32, "counter", 10)

        # Start the timer
        timer_delta_t_in_seconds = 0.5
        self.create_timer(
            timer_delta_t_in_seconds, self.timer_callback)

    # Respond to the timer
    def timer_callback(self):
        self.counter += 1
        # Publish the current counter value
        self.publisher.publish(UInt32(data=self.counter))


def main():
    # Take ROS's own arguments (such as -r __ns:=/mrp)
    rclpy.init()

    # Start an instance of the class
    publisher_py_node = PublisherPyNode()

    # Call the callbacks until shutdown
    try:
        rclpy.spin(publisher_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
