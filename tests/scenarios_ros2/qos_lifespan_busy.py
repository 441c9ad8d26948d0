"""Messages wait while no thread spins: those older than the lifespan of their subscription are gone.

The publisher's own lifespan is for the messages it keeps for late subscriptions; these here have arrived already.
"""

import rclpy
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from scenario import P, begin, block, say
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("qos_lifespan_busy")
begin()
for offered, requested in ((1.5, 0), (0, 1.5), (1.5, 3.5), (3.5, 1.5)):
    seen = []
    publisher = node.create_publisher(UInt32, "numbers", QoSProfile(depth=10, lifespan=Duration(seconds=offered * P)))
    subscription = node.create_subscription(
        UInt32,
        "numbers",
        lambda message: seen.append(message.data),
        QoSProfile(depth=10, lifespan=Duration(seconds=requested * P)),
    )
    for number in range(5):
        publisher.publish(UInt32(data=number))
        block(1)
    for _ in range(10):
        rclpy.spin_once(node, timeout_sec=0.05)
    say(offered, requested, seen)
    node.destroy_subscription(subscription)
    node.destroy_publisher(publisher)
rclpy.shutdown()
