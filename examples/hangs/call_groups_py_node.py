#!/usr/bin/env python3

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.create_service(Trigger, "take_picture", self.picture_callback)
        self.client = self.create_client(Trigger, "take_picture")
        self.create_timer(
            1.0, self.timer_callback,
            callback_group=MutuallyExclusiveCallbackGroup())

    def picture_callback(self, request, response):
        response.message = "a picture"
        return response

    def timer_callback(self):
        self.get_logger().info("asks for a picture")
        answer = self.client.call(Trigger.Request())
        self.get_logger().info("has " + answer.message)


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node, MultiThreadedExecutor(2))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
