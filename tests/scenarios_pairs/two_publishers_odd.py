"""One of two processes that publish on a topic."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("odd")
publisher = node.create_publisher(UInt32, "numbers", 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
for number in range(1, 10, 2):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("the listener has gone")
rclpy.shutdown()
