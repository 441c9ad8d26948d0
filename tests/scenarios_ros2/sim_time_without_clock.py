"""use_sim_time without a node that tells the time: it is 0, and no timer ever ticks."""

import rclpy
from rclpy.parameter import Parameter
from scenario import P, begin, end_after, mark, say

rclpy.init()
node = rclpy.create_node("sim_time_without_clock", parameter_overrides=[Parameter("use_sim_time", value=True)])
begin()
node.create_timer(P, lambda: mark("tick"))
say(node.get_clock().now(), node.get_clock().ros_time_is_active)
say(node.get_parameter("use_sim_time").value)
end_after(3)
rclpy.spin(node)
