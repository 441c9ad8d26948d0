"""Messages that wait behind a slow callback grow too old meanwhile."""

import rclpy
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from scenario import P, begin, block, end_after, mark
from std_msgs.msg import UInt32


def receive(message):
    mark(f"seen_{message.data}")
    block(1)


def publish():
    for number in range(5):
        publisher.publish(UInt32(data=10 * len(rounds) + number))
    rounds.append(None)


rounds = []
rclpy.init()
node = rclpy.create_node("qos_lifespan_slow_callback")
publisher = node.create_publisher(UInt32, "numbers", 10)
profile = QoSProfile(depth=10, lifespan=Duration(seconds=2.5 * P))
subscription = node.create_subscription(UInt32, "numbers", receive, profile)
begin()
timer = node.create_timer(6 * P, publish)
end_after(20)
rclpy.spin(node)
