"""Has two nodes."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String, UInt32

rclpy.init()
node = rclpy.create_node("right")
another = rclpy.create_node("another", namespace="deep/inside")
words = []
publisher = node.create_publisher(UInt32, "numbers", 10)
another.create_subscription(String, "/robot/words", words.append, 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
publisher.publish(UInt32(data=1))
spin_until(another, lambda: words)
say(words)
rclpy.shutdown()
