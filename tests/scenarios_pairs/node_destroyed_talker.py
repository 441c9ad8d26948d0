"""Sees that a node of the other process has gone."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher, more = (node.create_publisher(UInt32, name, 10) for name in ("numbers", "more"))
spin_until(node, lambda: publisher.get_subscription_count() == more.get_subscription_count() == 1)
for number in range(2):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
spin_until(node, lambda: len(node.get_node_names()) == 2)
say(sorted(node.get_node_names()), more.get_subscription_count())
more.publish(UInt32(data=2))
spin_until(node, lambda: more.get_subscription_count() == 0)
rclpy.shutdown()
