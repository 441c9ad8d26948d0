#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.executors import SingleThreadedExecutor
from slow_py_node import SlowPyNode
from thirty_py_node import ThirtyPyNode


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    executor.add_node(ThirtyPyNode())
    executor.add_node(SlowPyNode())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
