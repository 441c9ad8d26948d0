"""An exception in a callback ends this process and no other."""

import rclpy
from scenario import say
from std_msgs.msg import UInt32


def receive(message):
    say("received", message.data)
    raise ValueError(f"number {message.data}")


rclpy.init()
node = rclpy.create_node("listener")
node.create_subscription(UInt32, "numbers", receive, 10)
rclpy.spin(node)
say("never printed")
