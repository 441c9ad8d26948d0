"""Ends after three numbers, without a shutdown."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
seen = []
node.create_subscription(UInt32, "numbers", lambda message: seen.append(message.data), 10)
spin_until(node, lambda: len(seen) == 3)
say(seen)
