"""Asks for a shorter deadline than the other process offers, and is warned."""

import rclpy
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from scenario import invite, say, spin_for, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("right")
subscription = node.create_subscription(UInt32, "numbers", print, QoSProfile(depth=5, deadline=Duration(seconds=1)))
invite(node)
spin_until(node, lambda: node.count_publishers("numbers") == 1)
spin_for(node, 1)
say("publishers:", subscription.get_publisher_count())
rclpy.shutdown()
