"""Offers less than the other process asks for, and hears of it by a callback of its own."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.qos import QoSProfile, qos_policy_name_from_kind
from scenario import say, spin_until, wait_for_invitation
from std_msgs.msg import UInt32


def tell(event):
    heard.append(event)
    say(event.total_count, event.total_count_change, qos_policy_name_from_kind(event.last_policy_kind))


heard = []
rclpy.init()
node = rclpy.create_node("left")
publisher = node.create_publisher(
    UInt32,
    "numbers",
    QoSProfile(depth=5, deadline=Duration(seconds=5)),
    event_callbacks=PublisherEventCallbacks(incompatible_qos=tell),
)
wait_for_invitation(node)
spin_until(node, lambda: heard)
say("subscriptions:", publisher.get_subscription_count())
spin_until(node, lambda: node.count_subscribers("numbers") == 0)
rclpy.shutdown()
