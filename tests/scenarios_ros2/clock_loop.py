"""A loop on clock.sleep_until, each time a period later: one pass takes 1.4 periods, the grid is kept."""

import rclpy
from rclpy.duration import Duration
from scenario import P, begin, block, mark

rclpy.init()
node = rclpy.create_node("clock_loop")
begin()
clock = node.get_clock()
due = clock.now()
for number in range(6):
    mark("pass")
    if number == 2:
        block(1.4)
    due += Duration(seconds=P)
    clock.sleep_until(due)
mark("end_of_loop")
rclpy.shutdown()
