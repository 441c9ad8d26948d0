"""Ctrl-C is caught here."""

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("listener")
subscription = node.create_subscription(UInt32, "numbers", lambda message: say(message.data), 10)
spin_until(node, lambda: subscription.get_publisher_count() == 1)
say("connected")
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException) as error:
    say("caught", type(error).__name__, rclpy.ok())
