"""rclpy.shutdown() in another thread while a MultiThreadedExecutor spins, and one of its callbacks runs."""

import rclpy
from rclpy.executors import MultiThreadedExecutor
from scenario import P, after, begin, block, mark, say


def callback():
    mark("tick")
    block(1.7)
    mark("ended")


rclpy.init()
node = rclpy.create_node("shutdown_in_thread_multi")
begin()
node.create_timer(P, callback)
executor = MultiThreadedExecutor(2)
executor.add_node(node)
after(2, rclpy.shutdown)
try:
    executor.spin()
    say("spun")
except Exception as error:
    say(type(error).__name__, error.args)
mark("end_of_main")
