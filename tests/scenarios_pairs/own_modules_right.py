"""What it changes in a module, a class and the environment is its own."""

import os

import rclpy
from rclpy.node import Node
from robot import counter
from scenario import say, spin_until
from std_msgs.msg import UInt32


def receive(message):
    counter.step(100)
    heard.append(message.data)


heard = []
Node.owner = "right"
os.environ["OWNER"] = "right"
rclpy.init()
node = rclpy.create_node("right")
publisher = node.create_publisher(UInt32, "right", 10)
node.create_subscription(UInt32, "left", receive, 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
for number in range(3):
    publisher.publish(UInt32(data=number))
spin_until(node, lambda: len(heard) == 3)
say(heard, counter.count, Node.owner, os.environ["OWNER"])
publisher.wait_for_all_acked()
rclpy.shutdown()
