"""A node that tells the time itself: it jumps forward, one tick for it; back, and the next tick is a period later."""

import rclpy
from builtin_interfaces.msg import Time
from rclpy.parameter import Parameter
from rosgraph_msgs.msg import Clock
from scenario import begin, say

rclpy.init()
teller = rclpy.create_node("teller")
node = rclpy.create_node("sim_time_jumps", parameter_overrides=[Parameter("use_sim_time", value=True)])
publisher = teller.create_publisher(Clock, "/clock", 10)
clock = node.get_clock()
node.create_timer(1.0, lambda: say("tick", clock.now().nanoseconds / 1e9))
begin()
for second in (100, 100.5, 101, 101.5, 102, 107.5, 108, 109, 50, 50.5, 51, 51.5, 52):
    publisher.publish(Clock(clock=Time(sec=int(second), nanosec=int(second % 1 * 1e9))))
    while clock.now().nanoseconds != second * 1e9:
        rclpy.spin_once(node, timeout_sec=0.1)
    for _ in range(4):
        rclpy.spin_once(node, timeout_sec=0.02)
    say("told", second)
rclpy.shutdown()
