#!/usr/bin/env python3

import rclpy
from geometry_msgs.msg import Twist
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range


class ControllerPyNode(Node):
    def __init__(self):
        super().__init__("controller_py_node")
        self.range = 0.0
        self.last_heard = None
        self.publisher = self.create_publisher(Twist, "cmd_vel", 1)
        self.create_subscription(Range, "range", self.range_callback, 1)
        self.create_timer(0.02, self.timer_callback)

    def range_callback(self, message):
        self.range = message.range
        self.last_heard = self.get_clock().now()

    def timer_callback(self):
        command = Twist()
        if self.is_sensor_alive() and self.range > 1.0:
            command.linear.x = 0.5
        self.publisher.publish(command)

    def is_sensor_alive(self):
        if self.last_heard is None:
            return False
        silence = self.get_clock().now() - self.last_heard
        return silence < Duration(seconds=0.2)


def main():
    rclpy.init()
    controller_py_node = ControllerPyNode()
    try:
        rclpy.spin(controller_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
