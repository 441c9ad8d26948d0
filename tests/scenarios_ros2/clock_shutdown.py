"""rclpy.shutdown() in another thread wakes a clock that sleeps."""

import rclpy
from rclpy.duration import Duration
from scenario import P, after, begin, mark, say

rclpy.init()
node = rclpy.create_node("clock_shutdown")
begin()
after(1.5, rclpy.shutdown)
say(node.get_clock().sleep_for(Duration(seconds=10 * P)))
mark("woken")
say("ok", rclpy.ok())
try:
    say(node.get_clock().sleep_for(Duration(seconds=P)))
except Exception as error:
    say(type(error).__name__, error)
mark("end_of_main")
