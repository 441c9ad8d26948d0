"""Destroys its node and stays."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node, another = rclpy.create_node("listener"), rclpy.create_node("another")
seen, heard = [], []
node.create_subscription(UInt32, "numbers", lambda message: seen.append(message.data), 10)
another.create_subscription(UInt32, "more", lambda message: heard.append(message.data), 10)
spin_until(node, lambda: len(seen) == 2)
node.destroy_node()
say(seen, rclpy.ok())
spin_until(another, lambda: heard)
say(heard)
rclpy.shutdown()
