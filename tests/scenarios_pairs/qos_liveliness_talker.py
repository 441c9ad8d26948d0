"""Two publishers of automatic liveliness, one by hand, and how the process ends: one is destroyed, two just end."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.qos import LivelinessPolicy, QoSProfile
from scenario import begin, mark, say, spin_for, spin_until, wait_for_invitation
from std_msgs.msg import UInt32


def publish(topic, kind):
    profile = QoSProfile(depth=5, liveliness=kind, liveliness_lease_duration=Duration(seconds=1))
    callbacks = PublisherEventCallbacks(liveliness=lambda event: say(topic, "lost", event.total_count))
    return node.create_publisher(UInt32, topic, profile, event_callbacks=callbacks)


rclpy.init()
node = rclpy.create_node("talker")
automatic = publish("automatic", LivelinessPolicy.AUTOMATIC)
destroyed = publish("destroyed", LivelinessPolicy.AUTOMATIC)
manual = publish("manual", LivelinessPolicy.MANUAL_BY_TOPIC)
wait_for_invitation(node)
spin_until(node, lambda: automatic.get_subscription_count() == 1)
spin_until(node, lambda: manual.get_subscription_count() == 1)
spin_for(node, 1.5)
begin()
manual.assert_liveliness()
spin_for(node, 2.5)
automatic.publish(UInt32(data=1))
manual.publish(UInt32(data=1))
spin_for(node, 2.5)
node.destroy_publisher(destroyed)
spin_for(node, 1)
rclpy.shutdown()
mark("end")
