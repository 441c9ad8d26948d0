"""Each end counts with its own lease, from what it has seen; without one there is nothing to tell."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import P, after, begin, end_after, mark, say
from std_msgs.msg import UInt32

MANUAL, AUTOMATIC = LivelinessPolicy.MANUAL_BY_TOPIC, LivelinessPolicy.AUTOMATIC


def tell(name):
    def callback(event):
        fields = [field for field in dir(event) if not field.startswith("_")]
        mark(name)
        say(name, *[f"{field}={int(getattr(event, field))}" for field in fields])

    return callback


def profile(kind, lease):
    return QoSProfile(depth=10, liveliness=kind, liveliness_lease_duration=Duration(seconds=lease * P))


def publish(name, topic, *policies):
    events = PublisherEventCallbacks(liveliness=tell(name))
    return node.create_publisher(UInt32, topic, profile(*policies), event_callbacks=events)


def subscribe(name, topic, *policies):
    events = SubscriptionEventCallbacks(liveliness=tell(name))
    node.create_subscription(UInt32, topic, print, profile(*policies), event_callbacks=events)


rclpy.init()
node = rclpy.create_node("qos_liveliness_leases")
longer = publish("longer_pub", "longer", MANUAL, 1)
subscribe("longer_sub", "longer", MANUAL, 2.3)
other = publish("other_pub", "other", MANUAL, 1.2)
subscribe("other_sub", "other", AUTOMATIC, 1.6)
without = publish("without_pub", "without", MANUAL, 1.4)
subscribe("without_sub", "without", MANUAL, 0)
two = [publish(f"two_pub{number}", "two", MANUAL, 3) for number in range(2)]
before = publish("before_pub", "before", MANUAL, 2.6)
begin()
before.assert_liveliness()
subscribe("two_sub", "two", MANUAL, 3)
subscribe("before_sub", "before", MANUAL, 2.6)
for at, publisher in ((2, longer), (2.1, other), (2.2, without), (6, two[0]), (7.1, two[1]), (12, two[0])):
    after(at, publisher.assert_liveliness)
after(10.5, lambda: node.destroy_publisher(two[1]))
after(13, lambda: node.destroy_publisher(two[0]))
after(13.5, lambda: node.destroy_publisher(before))
end_after(15)
rclpy.spin(node)
