#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import UInt32


class AskingPyNode(Node):
    def __init__(self):
        super().__init__("asking_py_node")
        self.create_timer(0.2, self.timer_callback)

    # Wait for a message, five times a second: that cannot work
    def timer_callback(self):
        found, message = wait_for_message(
            UInt32, self, "counter", time_to_wait=2.0)
        self.get_logger().info(
            "[ASKING PY NODE] counter = "
            + (str(message.data) if found else "none"))


def main():
    rclpy.init()
    asking_py_node = AskingPyNode()
    try:
        rclpy.spin(asking_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
