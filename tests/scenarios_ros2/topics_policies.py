"""Which ends match by their policies, also by those that are left open, and who is given the old messages."""

import time
from itertools import product

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from scenario import begin, say
from std_msgs.msg import UInt32

STRICT = ("RELIABLE", "TRANSIENT_LOCAL")
FOUR = list(product(("RELIABLE", "BEST_EFFORT"), ("TRANSIENT_LOCAL", "VOLATILE")))
OPEN = [("SYSTEM_DEFAULT", "SYSTEM_DEFAULT"), ("BEST_AVAILABLE", "BEST_AVAILABLE")]
MIXED = [("SYSTEM_DEFAULT", "TRANSIENT_LOCAL"), ("RELIABLE", "BEST_AVAILABLE"), ("BEST_AVAILABLE", "TRANSIENT_LOCAL")]


def profile(reliability, durability):
    return QoSProfile(depth=2, reliability=ReliabilityPolicy[reliability], durability=DurabilityPolicy[durability])


def publish(topic, policies):
    publishers[topic] = node.create_publisher(UInt32, topic, profile(*policies))
    for number in range(3):
        publishers[topic].publish(UInt32(data=number))


def subscribe(topic, policies):
    node.create_subscription(UInt32, topic, lambda message: seen[topic].append(message.data), profile(*policies))


def spin():
    """Until nothing has come for a while."""
    before = time.monotonic()
    while time.monotonic() - before < 0.4:
        before = time.monotonic()
        rclpy.spin_once(node, timeout_sec=0.5)


rclpy.init()
begin()
publishers, seen = {}, {}
for order in (publish, subscribe), (subscribe, publish):
    node = rclpy.create_node(f"first_{order[0].__name__}")
    node.get_logger().set_level(40)
    for number, (offered, asked) in enumerate(product(FOUR + OPEN, FOUR + OPEN + MIXED)):
        topic = f"{order[0].__name__}_{number}"
        seen[topic] = [*offered, *asked, ":"]
        for make in order:
            make(topic, offered if make is publish else asked)
    spin()
    for topic, publisher in publishers.items():
        publisher.publish(UInt32(data=9))
    spin()
    for words in seen.values():
        say(*words)
    node.destroy_node()
    publishers, seen = {}, {}

node = rclpy.create_node("topics_policies")
for name, *order in ("strict", publish, subscribe), ("strict_first", subscribe, publish):
    for number, policies in enumerate(FOUR):
        topic = f"{name}_{number}"
        seen[topic] = list(policies)
        for make in order:
            make(topic, policies if make is publish else STRICT)
    spin()
rclpy.shutdown()
