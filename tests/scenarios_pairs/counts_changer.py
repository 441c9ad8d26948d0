"""Makes and destroys publishers, each when the other process has seen the last change."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String, UInt32

rclpy.init()
node = rclpy.create_node("changer")
seen = []
node.create_subscription(UInt32, "seen", lambda message: seen.append(message.data), 10)
first = node.create_publisher(String, "words", 10)
spin_until(node, lambda: seen == [1])
second = node.create_publisher(String, "words", 10)
spin_until(node, lambda: seen == [1, 2])
node.destroy_publisher(first)
spin_until(node, lambda: seen == [1, 2, 1])
node.destroy_publisher(second)
spin_until(node, lambda: seen == [1, 2, 1, 0])
say(seen)
rclpy.shutdown()
