"""A timer on each kind of clock, and one without a callback."""

import rclpy
from rclpy.clock import Clock, ClockType
from scenario import P, begin, end_after, mark, say

rclpy.init()
node = rclpy.create_node("timer_clocks")
begin()
for kind in (ClockType.SYSTEM_TIME, ClockType.STEADY_TIME, ClockType.ROS_TIME):
    timer = node.create_timer(1.5 * P, lambda kind=kind: mark(kind.name), clock=Clock(clock_type=kind))
    say(timer.clock.clock_type)
end_after(5)
rclpy.spin(node)
