"""Comes late and asks for new messages only."""

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import say, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
wait_for_invitation(node)
seen = []
node.create_subscription(
    UInt32,
    "numbers",
    lambda message: seen.append(message.data),
    QoSProfile(depth=10, durability=DurabilityPolicy.VOLATILE),
)
spin_until(node, lambda: 10 in seen)
say(seen)
rclpy.shutdown()
