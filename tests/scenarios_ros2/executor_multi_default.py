"""MultiThreadedExecutor, 4 threads, both timers in the node's default group: the fast one is never called."""

import rclpy
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark


def slow():
    mark("slow")
    block(1.6)
    mark("slow_ended")


rclpy.init()
node = rclpy.create_node("executor_multi_default")
begin()
node.create_timer(P, slow)
node.create_timer(P, lambda: mark("fast"))
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
end_after(6.7)
executor.spin()
