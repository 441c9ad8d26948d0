"""Misses a process that was killed when the leases of its publishers are over, long before the process itself."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import invite, say, spin_until
from std_msgs.msg import UInt32


def subscribe(topic, kind):
    def tell(event):
        heard[topic].append(
            (event.alive_count, event.alive_count_change, event.not_alive_count, event.not_alive_count_change)
        )

    heard[topic] = []
    profile = QoSProfile(depth=5, liveliness=kind, liveliness_lease_duration=Duration(seconds=1))
    return node.create_subscription(
        UInt32, topic, lambda message: None, profile, event_callbacks=SubscriptionEventCallbacks(liveliness=tell)
    )


rclpy.init()
node = rclpy.create_node("listener")
heard = {}
subscriptions = [
    subscribe("automatic", LivelinessPolicy.AUTOMATIC),
    subscribe("manual", LivelinessPolicy.MANUAL_BY_TOPIC),
]
invite(node)
spin_until(node, lambda: all(len(events) == 2 for events in heard.values()))
say(*[subscription.get_publisher_count() for subscription in subscriptions])
spin_until(node, lambda: all(len(events) == 3 for events in heard.values()))
say(*[subscription.get_publisher_count() for subscription in subscriptions])
for topic, events in heard.items():
    say(topic, *events)
rclpy.shutdown()
