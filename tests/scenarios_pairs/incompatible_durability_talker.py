"""Offers VOLATILE, the other process asks for TRANSIENT_LOCAL: both are warned, nothing arrives."""

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", QoSProfile(depth=5, durability=DurabilityPolicy.VOLATILE))
wait_for_invitation(node)
spin_until(node, lambda: node.count_subscribers("numbers") == 1)
for number in range(3):
    publisher.publish(UInt32(data=number))
    spin_for(node, 0.3)
say("subscriptions:", publisher.get_subscription_count(), "subscribers:", node.count_subscribers("numbers"))
spin_until(node, lambda: node.count_subscribers("numbers") == 0)
rclpy.shutdown()
