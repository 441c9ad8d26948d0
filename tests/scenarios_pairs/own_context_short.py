"""Shuts its context down and stays: the other process is not concerned."""

import time

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("short")
seen = []
node.create_subscription(UInt32, "numbers", lambda message: seen.append(message.data), 10)
spin_until(node, lambda: seen)
rclpy.shutdown()
say("ok:", rclpy.ok(), "seen:", seen)
time.sleep(1.0)
rclpy.init()
node = rclpy.create_node("again")
node.create_subscription(UInt32, "numbers", lambda message: seen.append(message.data), 10)
spin_until(node, lambda: len(seen) == 2)
say("ok:", rclpy.ok(), "seen:", seen)
