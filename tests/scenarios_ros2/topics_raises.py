"""An exception in a subscription's callback leaves rclpy.spin."""

import rclpy
from scenario import begin, say
from std_msgs.msg import String


def receive(message):
    say(message.data)
    raise ValueError("in a subscription")


rclpy.init()
node = rclpy.create_node("topics_raises")
publisher = node.create_publisher(String, "words", 10)
node.create_subscription(String, "words", receive, 10)
begin()
publisher.publish(String(data="word"))
rclpy.spin(node)
