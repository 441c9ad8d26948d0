#!/usr/bin/env python3

import rclpy
from my_robotics_pkg.publisher_py_node import PublisherPyNode
from my_robotics_pkg.subscriber_py_node import SubscriberPyNode
from rclpy.executors import ExternalShutdownException
from rclpy.executors import SingleThreadedExecutor


def main():
    # Take ROS's own arguments (such as -r __ns:=/mrp)
    rclpy.init()

    # Give both nodes to one executor
    executor = SingleThreadedExecutor()
    executor.add_node(PublisherPyNode())
    executor.add_node(SubscriberPyNode())

    # Call the callbacks until shutdown
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
