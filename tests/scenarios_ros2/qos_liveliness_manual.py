"""Liveliness by hand: a publisher lives as long as its lease after it publishes or says so."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import P, after, begin, block, end_after, mark, say
from std_msgs.msg import UInt32


def tell(name):
    def callback(event):
        fields = [field for field in dir(event) if not field.startswith("_")]
        mark(name)
        say(name, *[f"{field}={int(getattr(event, field))}" for field in fields])

    return callback


def make_busy():
    mark("busy")
    block(2.5)


rclpy.init()
node = rclpy.create_node("qos_liveliness_manual")
profile = QoSProfile(
    depth=10, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_duration=Duration(seconds=P)
)
publisher = node.create_publisher(
    UInt32, "numbers", profile, event_callbacks=PublisherEventCallbacks(liveliness=tell("lost"))
)
node.create_subscription(
    UInt32,
    "numbers",
    lambda message: mark("seen"),
    profile,
    event_callbacks=SubscriptionEventCallbacks(liveliness=tell("changed")),
)
guard = node.create_guard_condition(make_busy)
begin()
after(2.2, publisher.assert_liveliness)
after(2.8, publisher.assert_liveliness)
after(5.2, lambda: publisher.publish(UInt32()))
after(8.1, guard.trigger)
after(8.3, publisher.assert_liveliness)
after(11.2, publisher.assert_liveliness)
after(11.6, lambda: node.destroy_publisher(publisher))
end_after(13.5)
rclpy.spin(node)
