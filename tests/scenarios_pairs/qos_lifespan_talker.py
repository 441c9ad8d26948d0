"""Keeps messages for late subscriptions, and publishes to one that is busy."""

import time

import rclpy
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
kept = QoSProfile(depth=5, lifespan=Duration(seconds=30), durability=DurabilityPolicy.TRANSIENT_LOCAL)
gone = QoSProfile(depth=5, lifespan=Duration(seconds=0.2), durability=DurabilityPolicy.TRANSIENT_LOCAL)
publishers = [node.create_publisher(UInt32, *each) for each in (("kept", kept), ("gone", gone), ("busy", gone))]
for publisher in publishers[:2]:
    publisher.publish(UInt32(data=1))
time.sleep(1)
wait_for_invitation(node)
spin_until(node, lambda: all(publisher.get_subscription_count() == 1 for publisher in publishers))
spin_for(node, 1)
for number in range(2, 5):
    publishers[2].publish(UInt32(data=number))
    spin_for(node, 0.1)
spin_until(node, lambda: node.count_subscribers("busy") == 0)
say("end")
rclpy.shutdown()
