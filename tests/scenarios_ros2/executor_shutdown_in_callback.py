"""An executor that is shut down in a callback: spin returns after it; the context is still there."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, mark, say


def callback():
    mark("tick")
    say(executor.shutdown())


rclpy.init()
node = rclpy.create_node("executor_shutdown_in_callback")
begin()
node.create_timer(P, callback)
executor = SingleThreadedExecutor()
executor.add_node(node)
try:
    executor.spin()
except Exception as error:
    say(type(error).__name__, error)
mark("spun")
say("ok", rclpy.ok())
