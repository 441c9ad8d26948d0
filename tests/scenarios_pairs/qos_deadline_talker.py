"""Publishes three times, pauses, publishes again, and is gone."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.qos import QoSProfile
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

missed = []
rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(
    UInt32,
    "numbers",
    QoSProfile(depth=5, deadline=Duration(seconds=0.5)),
    event_callbacks=PublisherEventCallbacks(
        deadline=lambda event: missed.append(event.total_count),
        matched=lambda event: say("matched", event.current_count, event.total_count),
    ),
)
wait_for_invitation(node)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
for number in range(4):
    publisher.publish(UInt32(data=number))
    spin_for(node, 1.7 if number == 2 else 0.3)
say("missed", missed)
rclpy.shutdown()
