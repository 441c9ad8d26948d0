"""Clocks sleep for a while, until a time, and not at all until a time that is over."""

import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from scenario import P, attempt, begin, mark, say

rclpy.init()
node = rclpy.create_node("clock_sleeps")
begin()
for clock in (node.get_clock(), Clock(), Clock(clock_type=ClockType.STEADY_TIME)):
    say(clock.clock_type, type(clock).__name__)
    say(clock.sleep_for(Duration(seconds=0.75 * P)))
    mark("slept_for")
    say(clock.sleep_until(clock.now() + Duration(seconds=1.25 * P)))
    mark("slept_until")
    say(clock.sleep_until(clock.now() - Duration(seconds=0.1)), clock.sleep_for(Duration(seconds=-0.1)))
    mark("at_once")
names = {"node": node, "Clock": Clock, "ClockType": ClockType, "Duration": Duration}
for text in """
node.get_clock().sleep_for(0.1)
node.get_clock().sleep_until(5)
node.get_clock().sleep_until(Clock().now())
Clock(clock_type=7)
Clock(ClockType.ROS_TIME)
node.get_clock().ros_time_is_active
type(Clock(clock_type=ClockType.ROS_TIME)).__name__
Clock().ros_time_is_active
""".strip().splitlines():
    attempt(text, names)
rclpy.shutdown()
