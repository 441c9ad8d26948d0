"""MultiThreadedExecutor with 2 threads: a reentrant callback of 2.4 periods overlaps itself in both of them."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark


def callback():
    mark("tick")
    block(2.4)
    mark("ended")


rclpy.init()
node = rclpy.create_node("executor_multi_two_threads")
begin()
node.create_timer(P, callback, callback_group=ReentrantCallbackGroup())
end_after(7.7)
rclpy.spin(node, executor=MultiThreadedExecutor(2))
