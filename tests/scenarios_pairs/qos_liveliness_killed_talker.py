"""Is killed: it says no more that it is alive, by itself or by hand."""

import os
import signal

import rclpy
from rclpy.duration import Duration
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import spin_for, spin_until, wait_for_invitation
from std_msgs.msg import UInt32


def publish(topic, kind):
    profile = QoSProfile(depth=5, liveliness=kind, liveliness_lease_duration=Duration(seconds=1))
    return node.create_publisher(UInt32, topic, profile)


rclpy.init()
node = rclpy.create_node("talker")
publishers = [publish("automatic", LivelinessPolicy.AUTOMATIC), publish("manual", LivelinessPolicy.MANUAL_BY_TOPIC)]
wait_for_invitation(node)
spin_until(node, lambda: all(publisher.get_subscription_count() == 1 for publisher in publishers))
spin_for(node, 1)
publishers[1].publish(UInt32(data=1))
spin_for(node, 0.5)
os.kill(os.getpid(), signal.SIGKILL)
