"""MultiThreadedExecutor with one thread says that it is of no use; timers in groups of their own take turns."""

import warnings

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, end_after, mark, say

warnings.showwarning = lambda message, category, *where: say(category.__name__, message)
rclpy.init()
node = rclpy.create_node("executor_multi_one_thread")
begin()
node.create_timer(P, lambda: (mark("first"), block(0.3)), MutuallyExclusiveCallbackGroup())
node.create_timer(P, lambda: (mark("second"), block(0.3)), MutuallyExclusiveCallbackGroup())
executor = MultiThreadedExecutor(num_threads=1)
executor.add_node(node)
end_after(4.9)
executor.spin()
