"""Comes late and asks for the old messages."""

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import say, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("keeper")
wait_for_invitation(node)
seen = []
node.create_subscription(
    UInt32,
    "numbers",
    lambda message: seen.append(message.data),
    QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL),
)
publisher = node.create_publisher(UInt32, "kept", 10)
spin_until(node, lambda: len(seen) == 3 and publisher.get_subscription_count() == 1)
publisher.publish(UInt32(data=len(seen)))
spin_until(node, lambda: 10 in seen)
say(seen)
rclpy.shutdown()
