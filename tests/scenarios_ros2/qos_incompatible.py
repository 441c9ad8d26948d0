"""Deadlines, kinds of liveliness, leases and lifespans: which ends match, and what the warnings say."""

import rclpy
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy
from scenario import begin, say
from std_msgs.msg import UInt32

LONG, SHORT = Duration(seconds=10), Duration(seconds=5)
AUTOMATIC, MANUAL = LivelinessPolicy.AUTOMATIC, LivelinessPolicy.MANUAL_BY_TOPIC
WEAK = {"reliability": ReliabilityPolicy.BEST_EFFORT, "durability": DurabilityPolicy.VOLATILE}
STRONG = {"reliability": ReliabilityPolicy.RELIABLE, "durability": DurabilityPolicy.TRANSIENT_LOCAL}

CASES = [
    ({"deadline": LONG}, {"deadline": SHORT}),
    ({"deadline": SHORT}, {"deadline": LONG}),
    ({"deadline": SHORT}, {"deadline": SHORT}),
    ({}, {"deadline": SHORT}),
    ({"deadline": SHORT}, {}),
    ({"liveliness": AUTOMATIC}, {"liveliness": MANUAL}),
    ({"liveliness": MANUAL}, {"liveliness": AUTOMATIC}),
    ({}, {"liveliness": AUTOMATIC}),
    ({}, {"liveliness": MANUAL}),
    ({"liveliness": MANUAL}, {}),
    ({"liveliness_lease_duration": LONG}, {"liveliness_lease_duration": SHORT}),
    ({"liveliness_lease_duration": SHORT}, {"liveliness_lease_duration": LONG}),
    ({}, {"liveliness_lease_duration": SHORT}),
    ({"lifespan": LONG}, {"lifespan": SHORT}),
    ({"lifespan": SHORT}, {}),
    ({"deadline": LONG, **WEAK}, {"deadline": SHORT, **STRONG}),
    ({"deadline": LONG, "durability": WEAK["durability"]}, {"deadline": SHORT, "durability": STRONG["durability"]}),
    ({"deadline": LONG}, {"deadline": SHORT, "liveliness": MANUAL}),
    ({"liveliness": AUTOMATIC, **WEAK}, {"liveliness": MANUAL, **STRONG}),
]


def spin():
    for _ in range(3):
        rclpy.spin_once(node, timeout_sec=0.05)


rclpy.init()
node = rclpy.create_node("qos_incompatible")
begin()
for number, (offered, requested) in enumerate(CASES):
    offers, requests = QoSProfile(depth=1, **offered), QoSProfile(depth=1, **requested)
    publisher = node.create_publisher(UInt32, f"first_{number}", offers)
    subscription = node.create_subscription(UInt32, f"first_{number}", print, requests)
    spin()
    say(number, publisher.get_subscription_count(), subscription.get_publisher_count())
    subscription = node.create_subscription(UInt32, f"last_{number}", print, requests)
    publisher = node.create_publisher(UInt32, f"last_{number}", offers)
    spin()
    say(number, publisher.get_subscription_count(), subscription.get_publisher_count())
rclpy.shutdown()
