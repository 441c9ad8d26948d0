"""MultiThreadedExecutor, 4 threads, both timers in one ReentrantCallbackGroup: the slow one overlaps itself."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark


def slow():
    mark("slow")
    block(1.6)
    mark("slow_ended")


rclpy.init()
node = rclpy.create_node("executor_multi_reentrant")
group = ReentrantCallbackGroup()
begin()
node.create_timer(P, slow, group)
node.create_timer(P, lambda: mark("fast"), group)
executor = MultiThreadedExecutor(num_threads=4)
executor.add_node(node)
end_after(6.7)
executor.spin()
