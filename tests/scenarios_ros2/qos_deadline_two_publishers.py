"""Two publishers, and a subscription with another deadline: who is told when. A publisher's end stops no clock."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import QoSProfile
from scenario import P, after, begin, end_after, mark, say
from std_msgs.msg import UInt32


def tell(name):
    def callback(event):
        fields = [field for field in dir(event) if not field.startswith("_")]
        mark(name)
        say(name, *[f"{field}={int(getattr(event, field))}" for field in fields])

    return callback


def make(name):
    events = PublisherEventCallbacks(deadline=tell(name))
    return node.create_publisher(
        UInt32, "numbers", QoSProfile(depth=10, deadline=Duration(seconds=P)), event_callbacks=events
    )


rclpy.init()
node = rclpy.create_node("qos_deadline_two_publishers")
first, second = make("first"), make("second")
node.create_subscription(
    UInt32,
    "numbers",
    lambda message: mark(f"seen_{message.data}"),
    QoSProfile(depth=10, deadline=Duration(seconds=2.5 * P)),
    event_callbacks=SubscriptionEventCallbacks(deadline=tell("requested")),
)
node.create_subscription(
    UInt32, "other", print, 10, event_callbacks=SubscriptionEventCallbacks(deadline=tell("without"))
)
begin()
after(1.1, lambda: first.publish(UInt32(data=1)))
after(3.3, lambda: second.publish(UInt32(data=2)))
after(4.5, lambda: node.destroy_publisher(first))
after(6.8, lambda: node.destroy_publisher(second))
end_after(13)
rclpy.spin(node)
