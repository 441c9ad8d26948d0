"""sys.exit in a callback ends the process with its status."""

import sys

import rclpy
from scenario import P, begin, mark


def callback():
    mark("tick")
    sys.exit(3)


rclpy.init()
node = rclpy.create_node("timer_exits")
begin()
node.create_timer(P, callback)
rclpy.spin(node)
