"""A throttled log on a simulator's clock: nothing before that has come as far as the throttle is long."""

import rclpy
from rclpy.clock import ROSClock
from rclpy.parameter import Parameter
from rclpy.time import Time
from rclpy.time_source import TimeSource
from rosgraph_msgs.msg import Clock
from scenario import say

rclpy.init()
node = rclpy.create_node("log_throttle_sim_time", parameter_overrides=[Parameter("use_sim_time", value=True)])
logger = node.get_logger()
source = TimeSource(node=node)
clock = ROSClock()
source.attach_clock(clock)
say(clock.ros_time_is_active)
for ms in (0, 400, 800, 1200, 1600, 2000, 2400):
    source.clock_callback(Clock(clock=Time(seconds=ms // 1000, nanoseconds=ms % 1000 * 10**6).to_msg()))
    say(ms, logger.info(f"at {ms} ms", throttle_duration_sec=1.0, throttle_time_source_type=clock))
for number in range(2):
    say(number, logger.info(f"{number} in real time", throttle_duration_sec=1000.0))
rclpy.shutdown()
