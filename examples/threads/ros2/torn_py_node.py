#!/usr/bin/env python3

import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import (
    ExternalShutdownException, MultiThreadedExecutor)
from rclpy.node import Node


class OdometerPyNode(Node):
    def __init__(self):
        super().__init__("odometer_py_node")
        # Turns of the wheels: always a pair
        self.left = 0
        self.right = 0
        # Callbacks of this group may run at the same time
        group = ReentrantCallbackGroup()
        self.create_timer(0.5, self.read_callback, group)
        self.create_timer(0.6, self.report_callback, group)

    # Read both wheels, one after the other
    def read_callback(self):
        self.left += 1
        time.sleep(0.25)  # the sensor is slow
        self.right += 1

    # Report both wheels
    def report_callback(self):
        self.get_logger().info(
            f"[WHEELS] left = {self.left}, right = {self.right}")


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(OdometerPyNode())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
