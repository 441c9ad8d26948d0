"""A subscription that asks for more than the publisher offers gets nothing, and a warning."""

import rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from scenario import begin, say
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("topics_incompatible")
publisher = node.create_publisher(UInt32, "numbers", qos_profile_sensor_data)
seen = []
node.create_subscription(UInt32, "numbers", seen.append, QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE))
begin()
for _ in range(10):
    publisher.publish(UInt32(data=1))
    rclpy.spin_once(node, timeout_sec=0.05)
say(seen)
rclpy.shutdown()
