"""Its parameters and its command line are its own, though the nodes are called alike."""

import sys

import rclpy
from rclpy.parameter import Parameter
from scenario import say, spin_until
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("node")
say(sys.argv[1:])
say(node.declare_parameter("rate", 1.0).value, node.declare_parameter("name", "left").value)
heard = []
publisher = node.create_publisher(String, "left", 10)
node.create_subscription(String, "right", lambda message: heard.append(message.data), 10)
node.set_parameters([Parameter("name", value="changed by left")])
spin_until(node, lambda: publisher.get_subscription_count() == 1)
publisher.publish(String(data="set"))
spin_until(node, lambda: heard)
say(node.get_parameter("name").value)
publisher.wait_for_all_acked()
rclpy.shutdown()
