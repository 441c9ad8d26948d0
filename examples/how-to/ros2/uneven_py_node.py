#!/usr/bin/env python3

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class UnevenPyNode(Node):
    def __init__(self):
        super().__init__("uneven_py_node")
        self.counter = 0
        self.last_began = None
        self.create_timer(0.1, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        message = "[UNEVEN PY NODE] counter = " + str(self.counter)

        # When did the last call begin, and how long did it take?
        began = time.monotonic()
        if self.last_began is not None:
            message += ", %.3f s after a call that took %.3f s" % (
                began - self.last_began, self.last_duration)
        self.get_logger().info(message)

        # Every fifth call has more to do
        if self.counter % 5 == 0:
            time.sleep(0.25)

        self.last_began = began
        self.last_duration = time.monotonic() - began


def main():
    rclpy.init()
    uneven_py_node = UnevenPyNode()
    try:
        rclpy.spin(uneven_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
