"""A timer that destroys itself, and one that is destroyed by another."""

import rclpy
from scenario import P, begin, end_after, mark, say


def once():
    mark("once")
    say(node.destroy_timer(first), node.destroy_timer(first), len(list(node.timers)))


def destroy():
    mark("destroy")
    node.destroy_timer(second)
    third.cancel()
    try:
        second.reset()
    except Exception as error:
        say(type(error).__name__)


rclpy.init()
node = rclpy.create_node("timer_destroyed")
begin()
first = node.create_timer(P, once)
second = node.create_timer(0.75 * P, lambda: mark("second"))
third = node.create_timer(2 * P, destroy)
end_after(4.3)
rclpy.spin(node)
