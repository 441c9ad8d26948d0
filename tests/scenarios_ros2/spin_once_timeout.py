"""rclpy.spin_once with a timeout: it returns at the latest then, whether there was a callback or not."""

import rclpy
from scenario import P, begin, mark

rclpy.init()
node = rclpy.create_node("spin_once_timeout")
begin()
node.create_timer(1.5 * P, lambda: mark("tick"))
for timeout in (0, 0.5 * P, 0.5 * P, P, P, 2 * P, 0, 0):
    rclpy.spin_once(node, timeout_sec=timeout)
    mark("spun")
rclpy.shutdown()
