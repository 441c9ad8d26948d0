"""Asks for TRANSIENT_LOCAL, the other process offers VOLATILE."""

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import invite, say, spin_for, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
seen = []
subscription = node.create_subscription(
    UInt32, "numbers", seen.append, QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
)
invite(node)
spin_until(node, lambda: node.count_publishers("numbers") == 1)
spin_for(node, 1.5)
say("publishers:", subscription.get_publisher_count(), node.count_publishers("numbers"), "seen:", seen)
rclpy.shutdown()
