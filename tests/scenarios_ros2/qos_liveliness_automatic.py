"""Automatic liveliness in one process: a subscription hears of it only with a message, and misses it after a lease."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import P, after, begin, end_after, mark, say
from std_msgs.msg import UInt32


def tell(name):
    def callback(event):
        fields = [field for field in dir(event) if not field.startswith("_")]
        mark(name)
        say(name, *[f"{field}={int(getattr(event, field))}" for field in fields])

    return callback


rclpy.init()
node = rclpy.create_node("qos_liveliness_automatic")
profile = QoSProfile(depth=10, liveliness=LivelinessPolicy.AUTOMATIC, liveliness_lease_duration=Duration(seconds=P))
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
begin()
after(2.2, lambda: publisher.publish(UInt32()))
after(5.2, lambda: publisher.publish(UInt32()))
after(5.9, lambda: publisher.publish(UInt32()))
after(9, lambda: node.destroy_publisher(publisher))
end_after(10)
rclpy.spin(node)
