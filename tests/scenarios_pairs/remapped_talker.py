"""Publishes on two topics; its own names are what they are."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("talker")
publishers = [node.create_publisher(String, name, 10) for name in ("words", "other")]
spin_until(node, lambda: publishers[1].get_subscription_count() == 1)
say([publisher.topic_name for publisher in publishers])
for publisher in publishers:
    publisher.publish(String(data=f"on {publisher.topic_name}"))
say([publisher.get_subscription_count() for publisher in publishers])
spin_until(node, lambda: publishers[1].get_subscription_count() == 0)
say("the listener has gone")
rclpy.shutdown()
