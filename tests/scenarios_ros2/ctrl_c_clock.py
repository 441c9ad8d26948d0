"""Ctrl-C while a clock sleeps."""

import rclpy
from rclpy.duration import Duration
from scenario import P, begin, mark

rclpy.init()
node = rclpy.create_node("ctrl_c_clock")
begin()
clock = node.get_clock()
due = clock.now()
while rclpy.ok():
    mark("pass")
    due += Duration(seconds=P)
    clock.sleep_until(due)
