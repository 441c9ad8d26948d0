"""An event's callback that raises ends the spin, as any other; what cannot be called shows only then."""

import rclpy
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from scenario import begin, say
from std_msgs.msg import UInt32


def refuse(event):
    raise ValueError(event.total_count)


rclpy.init()
node = rclpy.create_node("qos_events_raise")
begin()
for callback in (refuse, 5):
    publisher = node.create_publisher(UInt32, "numbers", 10, event_callbacks=PublisherEventCallbacks(matched=callback))
    subscription = node.create_subscription(UInt32, "numbers", print, 10)
    try:
        for _ in range(3):
            rclpy.spin_once(node, timeout_sec=0.1)
    except Exception as error:
        say(type(error).__name__, error)
    node.destroy_subscription(subscription)
    node.destroy_publisher(publisher)
for make in (
    lambda: node.create_publisher(UInt32, "numbers", 10, event_callbacks=5),
    lambda: node.create_subscription(UInt32, "numbers", print, 10, event_callbacks=5),
    lambda: PublisherEventCallbacks(message_lost=print),
    lambda: SubscriptionEventCallbacks(print),
):
    try:
        make()
    except Exception as error:
        say(type(error).__name__, str(error).partition(".__init__()")[2] or error)
callbacks = SubscriptionEventCallbacks(deadline=print, use_default_callbacks=False)
say(*[f"{name}={value}" for name, value in sorted(vars(callbacks).items()) if value is not print])
say(*[f"{name}={value}" for name, value in sorted(vars(PublisherEventCallbacks()).items())])
rclpy.shutdown()
