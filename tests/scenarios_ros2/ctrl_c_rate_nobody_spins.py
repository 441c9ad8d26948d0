"""Ctrl-C in the endless first sleep of a Rate for which no thread spins."""

import rclpy
from scenario import P, begin, mark

rclpy.init()
node = rclpy.create_node("ctrl_c_rate_nobody_spins")
begin()
rate = node.create_rate(1 / P)
while rclpy.ok():
    mark("pass")
    rate.sleep()
