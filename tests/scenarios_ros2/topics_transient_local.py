"""Who subscribes late sees the last messages of a transient local publisher, as deep as its history; else none."""

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import begin, say
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("topics_transient_local")
begin()
for depth, durability, asked in (
    (3, DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.TRANSIENT_LOCAL),
    (1, DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.TRANSIENT_LOCAL),
    (3, DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE),
    (3, DurabilityPolicy.VOLATILE, DurabilityPolicy.VOLATILE),
):
    publisher = node.create_publisher(UInt32, "numbers", QoSProfile(depth=depth, durability=durability))
    for number in range(10):
        publisher.publish(UInt32(data=number))
    seen = []
    subscription = node.create_subscription(
        UInt32, "numbers", lambda message: seen.append(message.data), QoSProfile(depth=10, durability=asked)
    )
    for _ in range(12):
        rclpy.spin_once(node, timeout_sec=0.05)
    say(depth, durability.name, asked.name, seen)
    node.destroy_subscription(subscription)
    node.destroy_publisher(publisher)
rclpy.shutdown()
