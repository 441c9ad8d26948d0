"""A Rate for which no thread spins: its first sleep has no end."""

import rclpy
from scenario import P, begin, end_after, mark

rclpy.init()
node = rclpy.create_node("rate_nobody_spins")
begin()
rate = node.create_rate(1 / P)
end_after(4)
while rclpy.ok():
    mark("pass")
    rate.sleep()
