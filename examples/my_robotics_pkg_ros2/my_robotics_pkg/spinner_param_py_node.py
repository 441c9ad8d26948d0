#!/usr/bin/env python3

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        # Start the node
        super().__init__("spinner_py_node")

        # Read the parameter; 2.0 if it is not set
        self.declare_parameter("frequency", 2.0)
        frequency_in_hz = self.get_parameter("frequency").value

        # Refuse what no timer can do
        if frequency_in_hz <= 0:
            self.get_logger().fatal(
                "[SPINNER PY NODE] frequency must be above 0")
            sys.exit(1)

        # Start counting from zero
        self.counter = 0

        # Start the timer, which takes a period
        timer_delta_t_in_seconds = 1.0 / frequency_in_hz
        self.create_timer(
            timer_delta_t_in_seconds, self.timer_callback)

    # Respond to the timer
    def timer_callback(self):
        self.counter += 1
        # Display the current counter value
        self.get_logger().info(
            "[SPINNER PY NODE] counter = " + str(self.counter))


def main():
    # Take ROS's own arguments (such as -p frequency:=10.0)
    rclpy.init()

    # Start an instance of the class
    spinner_py_node = SpinnerPyNode()

    # Call the callbacks until shutdown
    try:
        rclpy.spin(spinner_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
