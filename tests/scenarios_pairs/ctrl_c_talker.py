"""Ctrl-C comes to both processes: nothing catches it here."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

count = 0


def publish():
    global count
    if publisher.get_subscription_count() and count < 3:
        count += 1
        publisher.publish(UInt32(data=count))


rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", 10)
node.create_timer(0.2, publish)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
say("connected")
rclpy.spin(node)
say("never printed")
