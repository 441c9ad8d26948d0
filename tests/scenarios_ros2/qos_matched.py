"""Both ends of a topic are told who comes and goes; what happens while no thread spins is told at once."""

import rclpy
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from scenario import begin, say
from std_msgs.msg import UInt32


def tell(name):
    def callback(event):
        total = event.total_count, event.total_count_change
        say(name, *total, event.current_count, event.current_count_change)

    return callback


def spin():
    for _ in range(6):
        rclpy.spin_once(node, timeout_sec=0.05)


def publish(name):
    return node.create_publisher(UInt32, "numbers", 10, event_callbacks=PublisherEventCallbacks(matched=tell(name)))


def subscribe(name, kind=UInt32):
    events = SubscriptionEventCallbacks(matched=tell(name))
    return node.create_subscription(kind, "numbers", print, 10, event_callbacks=events)


rclpy.init()
node = rclpy.create_node("qos_matched")
begin()
publisher = publish("publisher")
spin()
say("a subscription")
subscription = subscribe("subscription")
spin()
say("two others")
others = [subscribe("second"), subscribe("third")]
spin()
say("a publisher")
second = publish("second publisher")
spin()
say("one goes, one comes")
node.destroy_subscription(others[0])
others[0] = subscribe("fourth")
spin()
say("comes and goes")
node.destroy_subscription(subscribe("fifth"))
spin()
say("the first publisher goes")
node.destroy_publisher(publisher)
spin()
say("the subscriptions go")
for each in (subscription, *others):
    node.destroy_subscription(each)
spin()
say(len(second.event_handlers), len(subscription.event_handlers))
rclpy.shutdown()
