"""sys.exit(3) in a callback ends this process and no other."""

import sys

import rclpy
from scenario import say
from std_msgs.msg import UInt32


def receive(message):
    say("received", message.data)
    sys.exit(3)


rclpy.init()
node = rclpy.create_node("listener")
node.create_subscription(UInt32, "numbers", receive, 10)
rclpy.spin(node)
say("never printed")
