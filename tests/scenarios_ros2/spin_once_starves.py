"""A slow timer and a fast one under rclpy.spin_once with what is left as timeout: the fast one is never called."""

import rclpy
from scenario import P, begin, block, mark, now


def slow():
    mark("slow")
    block(1.6)


rclpy.init()
node = rclpy.create_node("spin_once_starves")
begin()
node.create_timer(P, slow)
node.create_timer(P, lambda: mark("fast"))
while now() < 9.75 * P:
    rclpy.spin_once(node, timeout_sec=9.75 * P - now())
rclpy.shutdown()
