"""A lifecycle publisher sends while its node is active; one of the usual kind always."""

import rclpy
from rclpy.lifecycle import LifecycleNode, LifecyclePublisher
from scenario import attempt, say
from std_msgs.msg import UInt32

rclpy.init()
node = LifecycleNode("lifecycle_publisher")
other = rclpy.create_node("other")
other.create_subscription(UInt32, "numbers", lambda message: say("heard", message.data), 10)
other.create_subscription(UInt32, "always", lambda message: say("always", message.data), 10)
managed = node.create_lifecycle_publisher(UInt32, "numbers", 10)
usual = node.create_publisher(UInt32, "always", 10)
while not (managed.get_subscription_count() and usual.get_subscription_count()):
    rclpy.spin_once(other, timeout_sec=0.05)
say(isinstance(managed, LifecyclePublisher), managed.topic_name, managed.msg_type is UInt32, len(list(node.publishers)))


def publish(number):
    say("publish", number, managed.is_activated, managed.publish(UInt32(data=number)))
    usual.publish(UInt32(data=number))
    for _ in range(4):
        rclpy.spin_once(other, timeout_sec=0.05)


publish(1)
node.trigger_configure()
publish(2)
node.trigger_activate()
publish(3)
node.trigger_deactivate()
publish(4)
node.trigger_activate()
publish(5)
attempt("managed.publish(3)", {"managed": managed})
node.trigger_shutdown()
publish(6)  # it was not deactivated: the default callbacks leave it on
say(node.destroy_lifecycle_publisher(managed), node.destroy_lifecycle_publisher(managed))
attempt("managed.publish(m)", {"managed": managed, "m": UInt32()})
say(node.destroy_publisher(usual))
rclpy.shutdown()
