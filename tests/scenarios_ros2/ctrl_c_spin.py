"""Ctrl-C in rclpy.spin with nothing caught: KeyboardInterrupt."""

import rclpy
from scenario import P, begin, mark

rclpy.init()
node = rclpy.create_node("ctrl_c_spin")
begin()
node.create_timer(P, lambda: mark("tick"))
rclpy.spin(node)
print("never printed")
