"""Answers each number with its double."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32


def receive(message):
    say("asked", message.data)
    publisher.publish(UInt32(data=2 * message.data))


rclpy.init()
node = rclpy.create_node("server")
publisher = node.create_publisher(UInt32, "reply", 10)
subscription = node.create_subscription(UInt32, "request", receive, 10)
spin_until(node, lambda: publisher.get_subscription_count() == subscription.get_publisher_count() == 1)
spin_until(node, lambda: publisher.get_subscription_count() == subscription.get_publisher_count() == 0)
rclpy.shutdown()
