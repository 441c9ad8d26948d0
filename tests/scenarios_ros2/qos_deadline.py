"""Both ends are told of missed deadlines, from the first message on; a busy node hears of several at once."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import QoSProfile
from scenario import P, after, begin, block, end_after, mark, say
from std_msgs.msg import UInt32


def tell(name):
    def callback(event):
        fields = [field for field in dir(event) if not field.startswith("_")]
        mark(name)
        say(name, *[f"{field}={int(getattr(event, field))}" for field in fields])

    return callback


def publish():
    mark("publish")
    publisher.publish(UInt32())


def make_busy():
    mark("busy")
    block(3.5)


rclpy.init()
node = rclpy.create_node("qos_deadline")
profile = QoSProfile(depth=10, deadline=Duration(seconds=P))
publisher = node.create_publisher(
    UInt32, "numbers", profile, event_callbacks=PublisherEventCallbacks(deadline=tell("offered"))
)
node.create_subscription(
    UInt32,
    "numbers",
    lambda message: mark("seen"),
    QoSProfile(depth=10, deadline=Duration(seconds=1.45 * P)),
    event_callbacks=SubscriptionEventCallbacks(deadline=tell("requested")),
)
guard = node.create_guard_condition(make_busy)
begin()
after(2.2, publish)
after(2.9, publish)
after(6.2, guard.trigger)
after(11.3, publish)
end_after(13.8)
rclpy.spin(node)
