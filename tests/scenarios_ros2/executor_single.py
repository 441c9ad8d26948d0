"""SingleThreadedExecutor with two nodes: each timer keeps its own grid. Its nodes are in a set: they have no order."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, end_after, mark, say

rclpy.init()
first, second = rclpy.create_node("first"), rclpy.create_node("second")
begin()
first.create_timer(P, lambda: mark("first"))
second.create_timer(1.4 * P, lambda: mark("second"))
executor = SingleThreadedExecutor()
say(executor.add_node(first), executor.add_node(second), executor.add_node(second))
say(*sorted(node.get_name() for node in executor.get_nodes()))
end_after(6.6)
executor.spin()
