"""Events come first in an executor's round, in the order in which their ends were made; a coroutine may take them."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from scenario import begin, block, say
from std_msgs.msg import UInt32


async def matched(event):
    say("publisher", event.total_count)


rclpy.init()
node = rclpy.create_node("qos_events_order")
begin()
timer = node.create_timer(0.001, lambda: say("timer") or timer.cancel())
guard = node.create_guard_condition(lambda: say("guard"))
group = MutuallyExclusiveCallbackGroup()
publisher = node.create_publisher(
    UInt32, "numbers", 10, callback_group=group, event_callbacks=PublisherEventCallbacks(matched=matched)
)
first = node.create_subscription(
    UInt32,
    "numbers",
    lambda message: say("first message"),
    10,
    event_callbacks=SubscriptionEventCallbacks(matched=lambda event: say("first")),
)
second = node.create_subscription(
    UInt32,
    "numbers",
    lambda message: say("second message"),
    10,
    callback_group=group,
    event_callbacks=SubscriptionEventCallbacks(matched=lambda event: say("second")),
)
publisher.publish(UInt32())
guard.trigger()
block(1)
for _ in range(12):
    rclpy.spin_once(node, timeout_sec=0.1)
for end in (publisher, first, second):
    groups = {handler.callback_group for handler in end.event_handlers}
    say(group in groups, node.default_callback_group in groups, len(groups))
    say(*[handler.event_type.name for handler in end.event_handlers])
    say(all(handler in node.waitables for handler in end.event_handlers))
handlers = publisher.event_handlers
node.destroy_publisher(publisher)
say(any(handler in node.waitables for handler in handlers))
rclpy.spin_once(node, timeout_sec=0.1)
rclpy.spin_once(node, timeout_sec=0.1)
rclpy.shutdown()
