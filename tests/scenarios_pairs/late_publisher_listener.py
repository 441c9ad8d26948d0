"""Subscribes, and then lets the other process know."""

import rclpy
from scenario import invite, say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
seen = []
subscription = node.create_subscription(UInt32, "numbers", lambda message: seen.append(message.data), 10)
invite(node)
spin_until(node, lambda: len(seen) == 5)
say(seen)
spin_until(node, lambda: subscription.get_publisher_count() == 0)
say("the talker has gone")
rclpy.shutdown()
