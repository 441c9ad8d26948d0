"""Each call of a timer takes block:= periods: it ticks as soon as it can, one tick for whatever was missed."""

import rclpy
from scenario import P, arg, begin, block, end_after, mark


def callback():
    mark("tick")
    block(arg("block"))


rclpy.init()
node = rclpy.create_node("timer_blocked_always")
begin()
node.create_timer(P, callback)
end_after(9.75)
rclpy.spin(node)
