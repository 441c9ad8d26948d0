"""Ctrl-C under a MultiThreadedExecutor, nothing runs just then."""

import rclpy
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, mark, say

rclpy.init()
node = rclpy.create_node("ctrl_c_multi")
begin()
node.create_timer(P, lambda: mark("tick"))
executor = MultiThreadedExecutor(2)
executor.add_node(node)
try:
    executor.spin()
except KeyboardInterrupt:
    say("caught", rclpy.ok())
