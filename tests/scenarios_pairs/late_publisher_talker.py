"""Publishes at once, with a publisher made when the processes know each other: nothing is lost."""

import rclpy
from rclpy.duration import Duration
from scenario import begin, mark, say, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
wait_for_invitation(node)
begin()
publisher = node.create_publisher(UInt32, "numbers", 10)
for number in range(5):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: publisher.get_subscription_count() == 1)
mark("connected")
say("acknowledged:", publisher.wait_for_all_acked(Duration(seconds=10)))
rclpy.shutdown()
