#!/usr/bin/env python3

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_srvs.srv import Trigger


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.takes = self.declare_parameter("takes", 0.35).value
        self.pictures = 0
        # Offer a service, and be its client
        self.create_service(Trigger, "take_picture", self.picture_callback)
        self.client = self.create_client(Trigger, "take_picture")
        # Ask for a picture, and drive the motor
        self.create_timer(1.0, self.ask_callback)
        self.create_timer(0.1, self.motor_callback)

    # Serve a request
    def picture_callback(self, request, response):
        time.sleep(self.takes)  # the work
        self.pictures += 1
        response.success = True
        response.message = f"picture {self.pictures}"
        return response

    # Ask, and do not wait
    def ask_callback(self):
        future = self.client.call_async(Trigger.Request())
        future.add_done_callback(self.done_callback)

    # Respond to the answer
    def done_callback(self, future):
        self.get_logger().info("has " + future.result().message)

    def motor_callback(self):
        pass  # a command to the motor


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
