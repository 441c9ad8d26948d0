"""A message that was kept for a late subscription starts its deadline; a publisher counts from the first on."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import P, begin, block, end_after, mark, say
from std_msgs.msg import UInt32


def tell(name):
    def callback(event):
        fields = [field for field in dir(event) if not field.startswith("_")]
        mark(name)
        say(name, *[f"{field}={int(getattr(event, field))}" for field in fields])

    return callback


rclpy.init()
node = rclpy.create_node("qos_deadline_late")
profile = QoSProfile(depth=10, deadline=Duration(seconds=P), durability=DurabilityPolicy.TRANSIENT_LOCAL)
publisher = node.create_publisher(
    UInt32, "numbers", profile, event_callbacks=PublisherEventCallbacks(deadline=tell("offered"))
)
begin()
publisher.publish(UInt32())
block(3.5)
node.create_subscription(
    UInt32,
    "numbers",
    lambda message: mark("seen"),
    profile,
    event_callbacks=SubscriptionEventCallbacks(deadline=tell("requested")),
)
end_after(4.2)
rclpy.spin(node)
