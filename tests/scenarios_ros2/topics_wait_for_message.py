"""wait_for_message returns whether one came and the message, or after its timeout that none did."""

import rclpy
from rclpy.wait_for_message import wait_for_message
from scenario import P, after, begin, mark, say
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("topics_wait_for_message")
publisher = node.create_publisher(UInt32, "numbers", 10)
begin()
node.create_timer(P, lambda: mark("never"))
after(1.5, lambda: publisher.publish(UInt32(data=7)))
say(wait_for_message(UInt32, node, "numbers"))
mark("first")
say(wait_for_message(UInt32, node, "numbers", time_to_wait=1.4 * P))
mark("second")
rclpy.shutdown()
