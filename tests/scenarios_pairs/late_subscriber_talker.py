"""Publishes before and after there is a listener: what came before is lost."""

import rclpy
from scenario import invite, say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", 10)
for number in range(3):
    publisher.publish(UInt32(data=number))
say("subscriptions:", publisher.get_subscription_count())
invite(node)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
for number in range(3, 6):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("the listener has gone")
rclpy.shutdown()
