"""Who subscribes late sees only kept messages that are not older than their lifespan."""

import rclpy
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import P, begin, block, say
from std_msgs.msg import UInt32


def profile(depth, lifespan):
    return QoSProfile(depth=depth, lifespan=Duration(seconds=lifespan * P), durability=DurabilityPolicy.TRANSIENT_LOCAL)


rclpy.init()
node = rclpy.create_node("qos_lifespan_late")
begin()
for depth, offered, requested in ((10, 2.5, 0), (10, 0, 2.5), (10, 2.5, 1.5), (10, 1.5, 2.5), (1, 2.5, 0), (1, 0.5, 0)):
    seen = []
    publisher = node.create_publisher(UInt32, "numbers", profile(depth, offered))
    for number in range(5):
        publisher.publish(UInt32(data=number))
        block(1)
    subscription = node.create_subscription(
        UInt32, "numbers", lambda message: seen.append(message.data), profile(10, requested)
    )
    for _ in range(10):
        rclpy.spin_once(node, timeout_sec=0.05)
    say(depth, offered, requested, seen)
    node.destroy_subscription(subscription)
    node.destroy_publisher(publisher)
rclpy.shutdown()
