"""What is left to the best available is settled by the ends that are there already."""

import rclpy
from rclpy.duration import Duration
from rclpy.qos import LivelinessPolicy, QoSProfile, qos_profile_best_available, qos_profile_sensor_data
from scenario import begin, say
from std_msgs.msg import UInt32


def profile(deadline=0, lease=0, kind=LivelinessPolicy.MANUAL_BY_TOPIC):
    return QoSProfile(
        depth=1,
        deadline=Duration(seconds=deadline),
        liveliness_lease_duration=Duration(seconds=lease),
        liveliness=kind,
    )


PROFILES = [
    profile(),
    profile(10, 5),
    profile(0, 20),
    profile(20),
    profile(7, 8, LivelinessPolicy.AUTOMATIC),
    QoSProfile(depth=1),
    qos_profile_sensor_data,
    qos_profile_best_available,
]


rclpy.init()
node = rclpy.create_node("qos_best_available")
node.get_logger().set_level(40)
begin()
best, probes = qos_profile_best_available, PROFILES[:-1]
for number, other in enumerate(PROFILES):
    name = f"numbers_{number}"
    publishers = [node.create_publisher(UInt32, name, each) for each in (other, PROFILES[1])]
    subscription = node.create_subscription(UInt32, name, print, best)
    probing = [node.create_publisher(UInt32, name, each) for each in probes]
    say("publishers", number, *[each.get_subscription_count() for each in (*publishers, *probing)])

    name = f"others_{number}"
    subscriptions = [node.create_subscription(UInt32, name, print, each) for each in (other, PROFILES[1])]
    publisher = node.create_publisher(UInt32, name, best)
    probing = [node.create_subscription(UInt32, name, print, each) for each in probes]
    say("subscriptions", number, *[each.get_publisher_count() for each in (*subscriptions, *probing)])

    subscription = node.create_subscription(UInt32, f"alone_{number}", print, best)
    publisher = node.create_publisher(UInt32, f"alone_{number}", other)
    say("alone", number, publisher.get_subscription_count())
rclpy.shutdown()
