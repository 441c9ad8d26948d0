"""The first of three: publishes when the next one is ready."""

import rclpy
from scenario import say, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("source")
publisher = node.create_publisher(UInt32, "raw", 10)
wait_for_invitation(node)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
count = 0


def publish():
    global count
    count += 1
    publisher.publish(UInt32(data=count))


timer = node.create_timer(0.2, publish)
spin_until(node, lambda: count == 5)
timer.cancel()
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say(count)
rclpy.shutdown()
