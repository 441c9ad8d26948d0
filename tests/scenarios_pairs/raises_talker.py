"""Continues when its listener has ended."""

import rclpy
from scenario import say, spin_for, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
publisher.publish(UInt32(data=1))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
publisher.publish(UInt32(data=2))
spin_for(node, 0.2)
say("ok:", rclpy.ok())
rclpy.shutdown()
