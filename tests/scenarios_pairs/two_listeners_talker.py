"""Publishes once both listeners are there."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", 10)
spin_until(node, lambda: publisher.get_subscription_count() == 2)
for number in range(5):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: publisher.get_subscription_count() == 1)
say("one listener has gone")
publisher.publish(UInt32(data=5))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("both listeners have gone")
rclpy.shutdown()
