"""Asks over one topic and is answered over another, each time when the last answer has come."""

import rclpy
from scenario import begin, mark, say, spin_until
from std_msgs.msg import UInt32


def receive(message):
    answers.append(message.data)
    if len(answers) < 4:
        publisher.publish(message)


rclpy.init()
node = rclpy.create_node("client")
answers = []
publisher = node.create_publisher(UInt32, "request", 10)
subscription = node.create_subscription(UInt32, "reply", receive, 10)
spin_until(node, lambda: publisher.get_subscription_count() == subscription.get_publisher_count() == 1)
begin()
publisher.publish(UInt32(data=3))
spin_until(node, lambda: len(answers) == 4)
mark("answered")
say(answers)
rclpy.shutdown()
