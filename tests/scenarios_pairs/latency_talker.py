"""Says in each message when it was published."""

import time

import rclpy
from scenario import say, spin_for, spin_until
from std_msgs.msg import Float64

rclpy.init()
node = rclpy.create_node("talker")
publisher = node.create_publisher(Float64, "stamps", 10)
spin_until(node, lambda: publisher.get_subscription_count() == 1)
spin_for(node, 0.5)
for _ in range(5):
    publisher.publish(Float64(data=time.time()))
    spin_for(node, 0.1)
spin_until(node, lambda: publisher.get_subscription_count() == 0)
say("done")
rclpy.shutdown()
