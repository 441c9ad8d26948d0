"""Comes late, and is busy when messages come: only kept ones have a lifespan."""

import time

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import invite, say, spin_for, spin_until
from std_msgs.msg import UInt32


def subscribe(topic, **policies):
    def receive(message):
        seen[topic].append(message.data)

    seen[topic] = []
    return node.create_subscription(UInt32, topic, receive, QoSProfile(depth=5, **policies))


seen = {}
rclpy.init()
node = rclpy.create_node("listener")
invite(node)
subscribe("kept", durability=DurabilityPolicy.TRANSIENT_LOCAL)
subscribe("gone", durability=DurabilityPolicy.TRANSIENT_LOCAL)
subscription = subscribe("busy")
spin_until(node, lambda: seen["kept"] and subscription.get_publisher_count() == 1)
spin_for(node, 0.3)
time.sleep(3)
spin_for(node, 0.3)
say(seen)
rclpy.shutdown()
