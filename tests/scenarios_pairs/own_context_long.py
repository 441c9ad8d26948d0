"""Has a context of its own, and sees the other process's second one."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("long")
publisher = node.create_publisher(UInt32, "numbers", 10)
for number in range(2):
    spin_until(node, lambda: publisher.get_subscription_count() == 1)
    spin_until(node, lambda: len(node.get_node_names()) == 2)
    say(sorted(node.get_node_names()))
    publisher.publish(UInt32(data=number))
    spin_until(node, lambda: publisher.get_subscription_count() == 0)
    say("ok:", rclpy.ok())
rclpy.shutdown()
