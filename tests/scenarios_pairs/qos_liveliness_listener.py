"""What a subscription hears of the publishers of another process."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import invite, say, spin_for, spin_until
from std_msgs.msg import UInt32


def subscribe(topic, kind):
    def tell(event):
        heard[topic].append(
            (event.alive_count, event.alive_count_change, event.not_alive_count, event.not_alive_count_change)
        )

    heard[topic] = []
    profile = QoSProfile(depth=5, liveliness=kind, liveliness_lease_duration=Duration(seconds=1))
    callbacks = SubscriptionEventCallbacks(liveliness=tell)
    return node.create_subscription(
        UInt32, topic, lambda message: seen.append(topic), profile, event_callbacks=callbacks
    )


rclpy.init()
node = rclpy.create_node("listener")
heard, seen = {}, []
automatic = subscribe("automatic", LivelinessPolicy.AUTOMATIC)
destroyed = subscribe("destroyed", LivelinessPolicy.AUTOMATIC)
manual = subscribe("manual", LivelinessPolicy.MANUAL_BY_TOPIC)
invite(node)
spin_until(node, lambda: len(seen) == 2)
spin_until(node, lambda: destroyed.get_publisher_count() == 0)
spin_until(node, lambda: automatic.get_publisher_count() == 0)
spin_for(node, 0.5)
say(sorted(seen))
for topic, events in heard.items():
    say(topic, *events)
rclpy.shutdown()
