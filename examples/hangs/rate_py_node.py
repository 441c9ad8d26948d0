#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.create_timer(1.0, self.timer_callback)

    # Let the lamp blink three times
    def timer_callback(self):
        rate = self.create_rate(5.0)
        for number in range(3):
            self.get_logger().info("blinks")
            rate.sleep()


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
