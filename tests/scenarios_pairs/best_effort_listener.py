"""Lets the other process know when it is connected."""

import rclpy
from rclpy.qos import qos_profile_sensor_data
from scenario import invite, say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
seen = []
subscription = node.create_subscription(
    UInt32, "numbers", lambda message: seen.append(message.data), qos_profile_sensor_data
)
spin_until(node, lambda: subscription.get_publisher_count() == 1)
invite(node)
spin_until(node, lambda: len(seen) == 5)
say(seen)
rclpy.shutdown()
