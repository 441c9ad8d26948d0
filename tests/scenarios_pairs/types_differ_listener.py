"""Expects numbers."""

import rclpy
from scenario import invite, say, spin_for, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
seen = []
subscription = node.create_subscription(UInt32, "topic", seen.append, 10)
invite(node)
spin_until(node, lambda: node.count_publishers("topic") == 1)
spin_for(node, 1.0)
say("publishers:", subscription.get_publisher_count(), node.count_publishers("topic"), "seen:", seen)
rclpy.shutdown()
