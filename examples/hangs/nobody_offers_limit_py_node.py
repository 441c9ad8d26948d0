#!/usr/bin/env python3

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_srvs.srv import Trigger


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.create_service(Trigger, "take_picture", self.picture_callback)
        self.client = self.create_client(Trigger, "take_pictures")

    def picture_callback(self, request, response):
        response.message = "a picture"
        return response


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        if not robot_py_node.client.wait_for_service(timeout_sec=2.0):
            robot_py_node.get_logger().error("no node offers "
                + robot_py_node.client.service_name)
            sys.exit(1)
        future = robot_py_node.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(robot_py_node, future)
        answer = future.result()
        robot_py_node.get_logger().info("has " + answer.message)
        rclpy.spin(robot_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
