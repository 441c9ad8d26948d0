"""Once both ends know each other, a best-effort publisher's messages arrive, too."""

import rclpy
from rclpy.qos import qos_profile_sensor_data
from scenario import say, spin_for, spin_until, wait_for_invitation
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(UInt32, "numbers", qos_profile_sensor_data)
wait_for_invitation(node)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
for number in range(5):
    publisher.publish(UInt32(data=number))
    spin_for(node, 0.05)
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("the listener has gone")
rclpy.shutdown()
