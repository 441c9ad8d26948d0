"""Hears that messages of another process are late, and still hears it when that has ended."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.qos import QoSProfile
from scenario import begin, invite, mark, say, spin_until
from std_msgs.msg import UInt32


def receive(message):
    say("received", message.data)
    begin()


def tell(event):
    mark(f"missed_{event.total_count}")
    missed.append(event.total_count_change)


missed = []
rclpy.init()
node = rclpy.create_node("listener")
node.create_subscription(
    UInt32,
    "numbers",
    receive,
    QoSProfile(depth=5, deadline=Duration(seconds=0.7)),
    event_callbacks=SubscriptionEventCallbacks(
        deadline=tell, matched=lambda event: say("matched", event.current_count, event.total_count)
    ),
)
invite(node)
spin_until(node, lambda: len(missed) == 5)
say("missed", missed)
rclpy.shutdown()
