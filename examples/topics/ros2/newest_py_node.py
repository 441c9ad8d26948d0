#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class NewestPyNode(Node):
    def __init__(self):
        super().__init__("newest_py_node")
        self.newest = None  # nothing has come yet
        self.create_subscription(
            UInt32, "counter", self.counter_callback, 1)
        self.create_timer(0.2, self.timer_callback)

    # Keep the newest value, and return
    def counter_callback(self, message):
        self.newest = message.data

    # Work with it, five times a second
    def timer_callback(self):
        if self.newest is None:
            return
        self.get_logger().info(
            "[NEWEST PY NODE] counter = " + str(self.newest))


def main():
    rclpy.init()
    newest_py_node = NewestPyNode()
    try:
        rclpy.spin(newest_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
