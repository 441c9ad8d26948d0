"""Publishes texts where the other process expects numbers: nothing arrives."""

import rclpy
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(String, "topic", 10)
wait_for_invitation(node)
spin_until(node, lambda: node.count_subscribers("topic") == 1)
for _ in range(3):
    publisher.publish(String(data="word"))
    spin_for(node, 0.2)
say("subscriptions:", publisher.get_subscription_count(), "subscribers:", node.count_subscribers("topic"))
say(dict(node.get_topic_names_and_types())["/topic"])
spin_until(node, lambda: node.count_subscribers("topic") == 0)
rclpy.shutdown()
