"""The grid of a Rate counts from create_rate, and it sleeps until a thread spins."""

import threading

import rclpy
from scenario import P, begin, end_after, mark, until


def loop():
    while True:
        rate.sleep()
        mark("pass")


rclpy.init()
node = rclpy.create_node("rate_late_spin")
begin()
rate = node.create_rate(1 / P)
threading.Thread(target=loop, daemon=True).start()
until(2.6)
mark("spin")
end_after(3.2)
rclpy.spin(node)
