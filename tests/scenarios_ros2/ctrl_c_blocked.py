"""Ctrl-C while a callback runs: KeyboardInterrupt is raised inside it."""

import rclpy
from scenario import P, begin, block, mark


def callback():
    mark("tick")
    try:
        block(10)
    finally:
        mark("woken")


rclpy.init()
node = rclpy.create_node("ctrl_c_blocked")
begin()
node.create_timer(P, callback)
rclpy.spin(node)
