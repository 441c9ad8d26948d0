"""Calls its node as the other process does: neither complains, both take part."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("twin")
seen = []
publisher = node.create_publisher(String, "from_second", 10)
node.create_subscription(String, "from_first", lambda message: seen.append(message.data), 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1 and len(node.get_node_names()) == 2)
say(node.get_node_names())
publisher.publish(String(data="second"))
spin_until(node, lambda: seen)
say(seen)
publisher.wait_for_all_acked()
rclpy.shutdown()
