"""Names of topics, as they are resolved and remapped, and what is known of them."""

import rclpy
from scenario import attempt
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("topics_names")
names = {"node": node, "String": String}
for text in """
node.create_publisher(String, 'a', 10).topic_name
node.create_publisher(String, 'old', 10).topic_name
node.create_publisher(String, '~/private', 10).topic_name
node.create_publisher(String, '/b', 10).topic
node.create_subscription(String, 'a', print, 10).topic_name
node.create_subscription(String, 'a', print, 10).topic
node.create_publisher(String, '5', 10)
node.create_publisher(String, '', 10)
node.create_publisher(String, 'a b', 10)
node.create_publisher(String, 'a', 10).get_subscription_count()
node.count_publishers('a'), node.count_subscribers('a')
node.count_publishers('nonsuch')
""".strip().splitlines():
    attempt(text, names)
