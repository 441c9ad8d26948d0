"""A timer keeps to the grid that begins when it is made."""

import rclpy
from scenario import P, begin, end_after, mark

rclpy.init()
node = rclpy.create_node("timer_grid")
begin()
node.create_timer(P, lambda: mark("tick"))
end_after(6.5)
rclpy.spin(node)
