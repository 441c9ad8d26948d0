"""Jumps that /clock and the parameter use_sim_time make."""

import rclpy
from builtin_interfaces.msg import Time
from rclpy.clock import JumpThreshold
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rosgraph_msgs.msg import Clock
from scenario import say

rclpy.init()
node = rclpy.create_node("clock_jumps_sim_time")
other = rclpy.create_node("other")
publisher = other.create_publisher(Clock, "/clock", 10)
clock = node.get_clock()
limit = JumpThreshold(min_forward=Duration(seconds=2), min_backward=Duration(nanoseconds=-1), on_clock_change=True)
handle = clock.create_jump_callback(
    limit,
    pre_callback=lambda: say("before"),
    post_callback=lambda jump: say("after", jump.clock_change, jump.delta, clock.ros_time_is_active),
)
for value in (True, False, True):
    say("use_sim_time", value)
    node.set_parameters([Parameter("use_sim_time", value=value)])
    if value:
        while not publisher.get_subscription_count():
            rclpy.spin_once(node, timeout_sec=0.05)
        for seconds in (10, 11, 13, 12, 20):
            say("clock", seconds)
            publisher.publish(Clock(clock=Time(sec=seconds)))
            for _ in range(4):
                rclpy.spin_once(node, timeout_sec=0.05)
rclpy.shutdown()
