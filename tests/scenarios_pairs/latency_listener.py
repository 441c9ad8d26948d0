"""How old the messages are that come."""

import time

import rclpy
from scenario import mark, say, spin_until
from std_msgs.msg import Float64


def receive(message):
    ages.append(time.time() - message.data)
    mark("age", ages[-1])


rclpy.init()
node = rclpy.create_node("listener")
ages = []
node.create_subscription(Float64, "stamps", receive, 10)
spin_until(node, lambda: len(ages) == 5)
say(len(ages))
rclpy.shutdown()
