"""init, shutdown, and init again: nodes of the first life are dead, a timer of the second one ticks."""

import rclpy
from scenario import P, begin, mark, say

for life in ("first", "second"):
    rclpy.init()
    node = rclpy.create_node(life)
    if life == "first":
        begin()
    timer = node.create_timer(P, lambda: mark(life))
    rclpy.spin_once(node)
    rclpy.spin_once(node)
    node.destroy_node()
    rclpy.shutdown()
    say("ok", rclpy.ok())
