"""Continues when its listener has ended."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
for number in range(3):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
publisher.publish(UInt32(data=3))
spin_until(node, lambda: node.get_node_names() == ["talker"])
say("alone:", node.get_node_names(), node.count_subscribers("numbers"))
rclpy.shutdown()
