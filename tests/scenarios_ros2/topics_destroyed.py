"""A subscription that destroys itself after two messages; a publisher that still publishes after a shutdown."""

import rclpy
from scenario import P, attempt, begin, mark, say
from std_msgs.msg import String


def receive(message):
    seen.append(message.data)
    mark("receive")
    if len(seen) == 2:
        say(node.destroy_subscription(subscription))


seen = []
rclpy.init()
node = rclpy.create_node("topics_destroyed")
publisher = node.create_publisher(String, "words", 10)
subscription = node.create_subscription(String, "words", receive, 10)
begin()
node.create_timer(P, lambda: publisher.publish(String(data="word")))
for _ in range(7):
    rclpy.spin_once(node)
say(seen)
rclpy.shutdown()
attempt("publisher.publish(String())", {"publisher": publisher, "String": String})
