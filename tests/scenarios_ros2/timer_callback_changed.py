"""A timer's callback may be any callable, may be changed, and its result is not looked at."""

import functools

import rclpy
from scenario import P, begin, end_after, mark


class Callable:
    def __call__(self):
        mark("object")
        timer.callback = functools.partial(mark, "partial")
        return 42


rclpy.init()
node = rclpy.create_node("timer_callback_changed")
begin()
timer = node.create_timer(P, Callable())
end_after(3.5)
rclpy.spin(node)
