"""A Rate in a callback under rclpy.spin: its second sleep has no end, and no timer ticks any more."""

import rclpy
from scenario import P, begin, end_after, mark, say


def callback():
    for number in range(3):
        mark("sleeps")
        rate.sleep()
        mark("slept")
    say("never said")


rclpy.init()
node = rclpy.create_node("rate_in_callback")
begin()
rate = node.create_rate(1 / P)
node.create_timer(1.5 * P, callback)
node.create_timer(0.75 * P, lambda: mark("other"))
end_after(6.1)
rclpy.spin(node)
