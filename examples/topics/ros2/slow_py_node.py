#!/usr/bin/env python3

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class SlowPyNode(Node):
    def __init__(self):
        super().__init__("slow_py_node")
        # Change 1 to 3, to 10 or to 100, and run it again
        depth = self.declare_parameter("depth", 1)
        self.create_subscription(
            UInt32, "counter", self.counter_callback, depth.value)

    # Take 0.8 s for each message
    def counter_callback(self, message):
        self.get_logger().info(
            "[SLOW PY NODE] counter = " + str(message.data))
        time.sleep(0.8)


def main():
    rclpy.init()
    slow_py_node = SlowPyNode()
    try:
        rclpy.spin(slow_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
