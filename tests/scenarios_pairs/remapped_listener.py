"""Is started with -r words:=other and another name for its node."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("listener")
seen = []
subscription = node.create_subscription(String, "words", lambda message: seen.append(message.data), 10)
spin_until(node, lambda: seen)
say(node.get_name(), subscription.topic_name, seen)
spin_until(node, lambda: len(node.get_node_names()) == 2)
say(sorted(node.get_node_names()))
rclpy.shutdown()
