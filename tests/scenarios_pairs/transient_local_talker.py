"""Keeps its last three messages for who comes late and asks for them."""

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import invite, say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL))
kept = []
node.create_subscription(UInt32, "kept", kept.append, 10)
for number in range(10):
    publisher.publish(UInt32(data=number))
invite(node, 2)
spin_until(node, lambda: publisher.get_subscription_count() == 2)
spin_until(node, lambda: kept)
publisher.publish(UInt32(data=10))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("the listeners have gone")
rclpy.shutdown()
