"""What a process sees of the other's nodes and topics."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String, UInt32

rclpy.init()
node = rclpy.create_node("left", namespace="/robot")
publisher = node.create_publisher(String, "words", 10)
numbers = []
node.create_subscription(UInt32, "/numbers", numbers.append, 10)
spin_until(node, lambda: numbers)
spin_until(node, lambda: len(node.get_node_names()) == 3)
for name, namespace in sorted(node.get_node_names_and_namespaces()):
    say(name, namespace)
spin_until(node, lambda: node.count_subscribers("/robot/words") == 1)
for name, types in sorted(node.get_topic_names_and_types()):
    say(name, types)
spin_until(node, lambda: len(node.get_publisher_names_and_types_by_node("right", "/")) == 3)
say(sorted(node.get_publisher_names_and_types_by_node("right", "/")))
spin_until(node, lambda: publisher.get_subscription_count() == 1)
publisher.publish(String(data="done"))
publisher.wait_for_all_acked()
spin_until(node, lambda: node.get_node_names() == ["left"])
say(node.get_node_names(), node.count_publishers("/numbers"))
rclpy.shutdown()
