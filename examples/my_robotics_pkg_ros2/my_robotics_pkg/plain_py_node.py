#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class PlainPyNode(Node):
    def __init__(self):
        # Start the node
        super().__init__("plain_py_node")

        # Display the namespace of the node
        self.get_logger().info(
            "[PLAIN PY NODE] namespace of node = " + self.get_namespace())


def main():
    # Take ROS's own arguments (such as -r __ns:=/mrp)
    rclpy.init()

    # Start an instance of the class
    plain_py_node = PlainPyNode()

    # Call the callbacks until shutdown
    try:
        rclpy.spin(plain_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
