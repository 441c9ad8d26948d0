#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import UInt32


class BeginPyNode(Node):
    def __init__(self):
        super().__init__("begin_py_node")
        # Begin with the first value that comes
        found, message = wait_for_message(
            UInt32, self, "counter", time_to_wait=5.0)
        self.counter = message.data if found else 0
        self.create_timer(0.2, self.timer_callback)

    # Count on from there
    def timer_callback(self):
        self.counter += 1
        self.get_logger().info(
            "[BEGIN PY NODE] counter = " + str(self.counter))


def main():
    rclpy.init()
    begin_py_node = BeginPyNode()
    try:
        rclpy.spin(begin_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
