"""Counts the other process's publishers, and tells of each count."""

import rclpy
from scenario import begin, mark, say, spin_until
from std_msgs.msg import String, UInt32

rclpy.init()
node = rclpy.create_node("watcher")
teller = node.create_publisher(UInt32, "seen", 10)
subscription = node.create_subscription(String, "words", print, 10)
spin_until(node, lambda: teller.get_subscription_count() == 1)
for number, count in enumerate((1, 2, 1, 0)):
    spin_until(node, lambda: subscription.get_publisher_count() == count)
    if number:
        mark("changed")
    spin_until(node, lambda: node.count_publishers("words") == count)
    say(count, node.count_publishers("words"), node.count_subscribers("words"))
    begin()
    teller.publish(UInt32(data=count))
teller.wait_for_all_acked()
rclpy.shutdown()
