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
        self.serve("plan", self.plan_callback)
        self.serve("locate", self.locate_callback)
        self.to_plan = self.ask("plan")
        self.to_locate = self.ask("locate")
        self.create_timer(1.0, self.timer_callback)

    # Each service and each client has a group of its own
    def serve(self, name, callback):
        self.create_service(
            Trigger, name, callback,
            callback_group=MutuallyExclusiveCallbackGroup())

    def ask(self, name):
        return self.create_client(
            Trigger, name,
            callback_group=MutuallyExclusiveCallbackGroup())

    # Plan a way from where the robot is
    def plan_callback(self, request, response):
        place = self.to_locate.call(Trigger.Request()).message
        response.message = "from " + place + " to the door"
        return response

    # Look for the robot on the way that is planned
    def locate_callback(self, request, response):
        way = self.to_plan.call(Trigger.Request()).message
        response.message = "the window, " + way
        return response

    def timer_callback(self):
        answer = self.to_plan.call(Trigger.Request())
        self.get_logger().info("goes " + answer.message)


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node, MultiThreadedExecutor(4))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
