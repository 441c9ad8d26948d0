"""Subscribes once the other process has published."""

import rclpy
from scenario import begin, mark, say, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
wait_for_invitation(node)
seen = []
begin()
subscription = node.create_subscription(UInt32, "numbers", lambda message: seen.append(message.data), 10)
spin_until(node, lambda: subscription.get_publisher_count() == 1)
mark("connected")
spin_until(node, lambda: len(seen) == 3)
mark("received")
say(seen)
rclpy.shutdown()
