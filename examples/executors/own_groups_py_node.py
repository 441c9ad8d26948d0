#!/usr/bin/env python3

import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class TwoTimersPyNode(Node):
    def __init__(self):
        super().__init__("two_timers_py_node")
        self.create_timer(
            0.5, self.slow_callback,
            callback_group=MutuallyExclusiveCallbackGroup())
        self.create_timer(
            0.5, self.quick_callback,
            callback_group=MutuallyExclusiveCallbackGroup())

    def slow_callback(self):
        self.get_logger().info("slow")
        time.sleep(0.8)  # the work

    def quick_callback(self):
        self.get_logger().info("quick")


def main():
    rclpy.init()
    two_timers_py_node = TwoTimersPyNode()
    try:
        rclpy.spin(two_timers_py_node, MultiThreadedExecutor(2))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
