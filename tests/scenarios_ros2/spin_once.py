"""A loop of rclpy.spin_once: one callback for each."""

import rclpy
from scenario import P, begin, block, mark, say

rclpy.init()
node = rclpy.create_node("spin_once")
begin()
node.create_timer(P, lambda: mark("first"))
node.create_timer(P, lambda: mark("second"))
for number in range(6):
    say(number, rclpy.spin_once(node))
block(2.4)
for number in range(4):
    rclpy.spin_once(node)
    mark("spun")
say("ok", rclpy.ok())
rclpy.shutdown()
say("ok", rclpy.ok())
