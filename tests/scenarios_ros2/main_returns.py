"""A main that ends without a shutdown: status 0, no timer ticks any more."""

import rclpy
from scenario import P, begin, mark, until

rclpy.init()
node = rclpy.create_node("main_returns")
begin()
node.create_timer(P, lambda: mark("tick"))
rclpy.spin_once(node)
until(2.5)
