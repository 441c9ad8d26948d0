"""What is published in a subscription's callback goes round: two topics back and forth, a period each."""

import rclpy
from scenario import begin, block, end_after, mark
from std_msgs.msg import UInt32


def ping(message):
    mark("ping")
    block(1)
    pong_publisher.publish(message)


def pong(message):
    mark("pong")
    block(0.5)
    ping_publisher.publish(message)


rclpy.init()
node = rclpy.create_node("topics_in_callback")
ping_publisher, pong_publisher = (node.create_publisher(UInt32, name, 1) for name in ("ping", "pong"))
node.create_subscription(UInt32, "ping", ping, 1)
node.create_subscription(UInt32, "pong", pong, 1)
begin()
ping_publisher.publish(UInt32(data=1))
end_after(5.2)
rclpy.spin(node)
