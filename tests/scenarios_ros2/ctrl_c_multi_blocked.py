"""Ctrl-C under a MultiThreadedExecutor while a callback runs in another thread: it continues to its end."""

import rclpy
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, block, mark, say


def callback():
    mark("tick")
    timer.cancel()
    block(5)
    mark("ended")
    say("ok", rclpy.ok())


rclpy.init()
node = rclpy.create_node("ctrl_c_multi_blocked")
begin()
timer = node.create_timer(P, callback)
executor = MultiThreadedExecutor(2)
executor.add_node(node)
try:
    executor.spin()
except KeyboardInterrupt:
    mark("caught")
