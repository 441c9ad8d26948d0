"""The second of three: hands the odd numbers on, squared."""

import rclpy
from scenario import invite, say, spin_until
from std_msgs.msg import UInt32


def receive(message):
    if message.data % 2:
        publisher.publish(UInt32(data=message.data**2))


rclpy.init()
node = rclpy.create_node("filter")
publisher = node.create_publisher(UInt32, "squares", 10)
node.create_subscription(UInt32, "raw", receive, 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
invite(node)
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("the sink has gone")
rclpy.shutdown()
