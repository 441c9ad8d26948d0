"""rclpy.spin_once(timeout_sec=0) in a loop of the node's own: a timer ticks when the loop comes by."""

import time

import rclpy
from scenario import P, begin, mark, now

rclpy.init()
node = rclpy.create_node("spin_polls")
begin()
node.create_timer(P, lambda: mark("tick"))
while rclpy.ok() and now() < 5.5 * P:
    rclpy.spin_once(node, timeout_sec=0)
    time.sleep(0.7 * P)
    mark("pass")
node.destroy_node()
rclpy.shutdown()
