"""An exception in a callback of a MultiThreadedExecutor is noticed when the next callback is handed out."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, mark, say


def callback():
    mark("raises")
    raise ValueError("in a callback")


rclpy.init()
node = rclpy.create_node("executor_multi_raises")
group = ReentrantCallbackGroup()
begin()
node.create_timer(2 * P, callback, group)
node.create_timer(1.5 * P, lambda: mark("other"), group)
executor = MultiThreadedExecutor(4)
executor.add_node(node)
try:
    executor.spin()
finally:
    mark("spun")
    say("ok", rclpy.ok())
