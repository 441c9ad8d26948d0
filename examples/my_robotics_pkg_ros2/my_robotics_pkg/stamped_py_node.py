#!/usr/bin/env python3

import rclpy
from my_robotics_interfaces.msg import Count
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time


class StampedPyNode(Node):
    def __init__(self):
        # Start the node
        super().__init__("stamped_py_node")

        # Display the namespace of the node
        self.get_logger().info(
            "[STAMPED PY NODE] namespace of node = " + self.get_namespace())

        # Start counting from zero
        self.counter = 0

        # Start the publisher
        self.publisher = self.create_publisher(Count, "counter", 10)

        # Start the subscriber
        self.create_subscription(
            Count, "counter", self.counter_callback, 10)

        # Start the timer
        timer_delta_t_in_seconds = 0.5
        self.create_timer(
            timer_delta_t_in_seconds, self.timer_callback)

    # Respond to the timer
    def timer_callback(self):
        self.counter += 1
        # Publish the current counter value, and the time
        message = Count()
        message.stamp = self.get_clock().now().to_msg()
        message.data = self.counter
        self.publisher.publish(message)

    # Respond to a message
    def counter_callback(self, message):
        # Display the counter value and when it was published
        time = Time.from_msg(message.stamp)
        self.get_logger().info(
            "[STAMPED PY NODE] counter = " + str(message.data)
            + ", published at " + str(time.nanoseconds / 1e9))


def main():
    # Take ROS's own arguments (such as -r __ns:=/mrp)
    rclpy.init()

    # Start an instance of the class
    stamped_py_node = StampedPyNode()

    # Call the callbacks until shutdown
    try:
        rclpy.spin(stamped_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
