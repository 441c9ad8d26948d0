"""What qos_check_compatible says of two profiles."""

from itertools import product

from rclpy.duration import Duration, Infinite
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy, qos_check_compatible
from scenario import say

LONG, SHORT = Duration(seconds=10), Duration(seconds=5)


def check(offered, requested):
    compatibility, reason = qos_check_compatible(QoSProfile(**BASE | offered), QoSProfile(**BASE | requested))
    say(offered, requested, compatibility.name, repr(reason))


BASE = {"depth": 1, "liveliness": LivelinessPolicy.AUTOMATIC}
for name, values in {
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
    "deadline": (Duration(), SHORT, LONG, Infinite),
    "liveliness_lease_duration": (Duration(), SHORT, LONG, Infinite),
    "lifespan": (Duration(), SHORT, LONG),
}.items():
    for offered, requested in product(values, values):
        check({name: offered}, {name: requested})
WEAK = {
    "reliability": ReliabilityPolicy.BEST_EFFORT,
    "durability": DurabilityPolicy.VOLATILE,
    "deadline": LONG,
    "liveliness_lease_duration": LONG,
}
STRONG = {
    "reliability": ReliabilityPolicy.RELIABLE,
    "durability": DurabilityPolicy.TRANSIENT_LOCAL,
    "deadline": SHORT,
    "liveliness_lease_duration": SHORT,
    "liveliness": LivelinessPolicy.MANUAL_BY_TOPIC,
}
OPEN = dict.fromkeys(("reliability", "durability", "liveliness"), 0)
for offered, requested in product((WEAK, STRONG, OPEN, {**OPEN, "deadline": SHORT}), repeat=2):
    check(offered, requested)
