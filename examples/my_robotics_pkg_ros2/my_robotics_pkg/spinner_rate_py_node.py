#!/usr/bin/env python3

from threading import Thread

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        # Start the node
        super().__init__("spinner_py_node")

        # Display the namespace of the node
        self.get_logger().info(
            "[SPINNER PY NODE] namespace of node = " + self.get_namespace())

        # Set the rate of the loop
        loop_frequency_in_hz = 2.0
        self.loop_rate = self.create_rate(loop_frequency_in_hz)

        # Start counting from zero
        self.counter = 0

        # Start the loop in a thread that does not outlive the node
        Thread(target=self.loop, daemon=True).start()

    # Loop until shutdown
    def loop(self):
        while rclpy.ok():
            self.counter += 1
            # Display the current counter value
            self.get_logger().info(
                "[SPINNER PY NODE] counter = " + str(self.counter))

            # Sleep for what is left of this period
            self.loop_rate.sleep()


def main():
    # Take ROS's own arguments (such as -r __ns:=/mrp)
    rclpy.init()

    # Start an instance of the class
    spinner_py_node = SpinnerPyNode()

    # Wake the loop until shutdown
    try:
        rclpy.spin(spinner_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
