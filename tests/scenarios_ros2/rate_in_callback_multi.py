"""A Rate in a callback under a MultiThreadedExecutor works, as does a timer in another group."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from scenario import P, begin, end_after, mark


def callback():
    timer.cancel()
    for _ in range(3):
        rate.sleep()
        mark("slept")
    mark("done")


rclpy.init()
node = rclpy.create_node("rate_in_callback_multi")
begin()
rate = node.create_rate(1 / P)
timer = node.create_timer(1.5 * P, callback)
node.create_timer(0.75 * P, lambda: mark("other"), MutuallyExclusiveCallbackGroup())
end_after(6.1)
rclpy.spin(node, MultiThreadedExecutor(4))
