"""Is started in the namespace /left."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("talker")
publishers = [node.create_publisher(String, name, 10) for name in ("words", "/words", "~/words")]
spin_until(node, lambda: publishers[1].get_subscription_count() == publishers[2].get_subscription_count() == 1)
for publisher in publishers:
    publisher.publish(String(data=publisher.topic_name))
say(node.get_fully_qualified_name(), [publisher.get_subscription_count() for publisher in publishers])
spin_until(node, lambda: publishers[1].get_subscription_count() == 0)
rclpy.shutdown()
