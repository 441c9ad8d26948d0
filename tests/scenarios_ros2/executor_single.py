"""SingleThreadedExecutor with two nodes; the timers of both take turns."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, block, end_after, mark, say


def slow():
    mark("slow")
    block(1.6)


rclpy.init()
first, second = rclpy.create_node("first"), rclpy.create_node("second")
begin()
first.create_timer(P, slow)
second.create_timer(P, lambda: mark("fast"))
executor = SingleThreadedExecutor()
say(executor.add_node(first), executor.add_node(second), executor.add_node(second))
say(*sorted(node.get_name() for node in executor.get_nodes()))
end_after(9.75)
executor.spin()
