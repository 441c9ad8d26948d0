"""Callbacks of one's own for ends that do not match: then nothing is logged. Else a warning for all that is new."""

import rclpy
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_policy_name_from_kind
from scenario import begin, say
from std_msgs.msg import UInt32

WEAK = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
STRONG = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def tell(name):
    def callback(event):
        say(name, event.total_count, event.total_count_change, qos_policy_name_from_kind(event.last_policy_kind))

    return callback


def spin():
    for _ in range(8):
        rclpy.spin_once(node, timeout_sec=0.05)


rclpy.init()
node = rclpy.create_node("qos_incompatible_callbacks")
begin()
publisher = node.create_publisher(
    UInt32, "told", WEAK, event_callbacks=PublisherEventCallbacks(incompatible_qos=tell("publisher"))
)
subscription = node.create_subscription(
    UInt32, "told", print, 10, event_callbacks=SubscriptionEventCallbacks(incompatible_qos=tell("subscription"))
)
spin()
node.create_subscription(UInt32, "told", print, STRONG)
node.create_subscription(UInt32, "told", print, WEAK)
spin()
say("counts", publisher.get_subscription_count(), subscription.get_publisher_count())

say("silent")
silent = {"use_default_callbacks": False}
node.create_subscription(UInt32, "silent", print, 10, event_callbacks=SubscriptionEventCallbacks(**silent))
node.create_publisher(UInt32, "silent", WEAK, event_callbacks=PublisherEventCallbacks(**silent))
spin()

say("all at once")
node.create_publisher(UInt32, "second", WEAK)
node.create_publisher(UInt32, "first", 10)
node.create_subscription(UInt32, "first", print, STRONG)
node.create_subscription(UInt32, "second", print, 10)
node.create_subscription(UInt32, "second", print, STRONG)
node.create_publisher(UInt32, "second", WEAK)
spin()
rclpy.shutdown()
