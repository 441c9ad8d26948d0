"""MultiThreadedExecutor, 4 threads, a MutuallyExclusiveCallbackGroup for each timer: neither waits for the other."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark


def slow():
    mark("slow")
    block(1.6)
    mark("slow_ended")


rclpy.init()
node = rclpy.create_node("executor_multi_exclusive")
begin()
node.create_timer(P, slow, MutuallyExclusiveCallbackGroup())
node.create_timer(P, lambda: mark("fast"), MutuallyExclusiveCallbackGroup())
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
end_after(6.7)
executor.spin()
