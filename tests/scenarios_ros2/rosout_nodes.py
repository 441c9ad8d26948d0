"""Several nodes on /rosout: one below another, one that could not be made, and one on simulated time."""

import rclpy
from rcl_interfaces.msg import Log
from rclpy.exceptions import InvalidParameterTypeException
from rclpy.node import Node
from rclpy.parameter import Parameter
from scenario import say


def hear(message):
    if message.name.startswith("above"):
        say(message.name, message.msg, message.stamp.sec > 0 or message.stamp.nanosec > 0)


def spin():
    for _ in range(6):
        rclpy.spin_once(listener, timeout_sec=0.1)


rclpy.init()
listener = rclpy.create_node("rosout_nodes")
listener.create_subscription(Log, "/rosout", hear, 10)
above = rclpy.create_node("above")
below = rclpy.create_node("below", namespace="/above")
spin()
below.get_logger().info("one")
spin()
above.destroy_node()
say(list(above.publishers))
below.get_logger().info("two")
spin()
try:
    Node("above", parameter_overrides=[Parameter("start_type_description_service", value="x")])
except (InvalidParameterTypeException, ValueError) as error:
    say(type(error).__name__)
again = rclpy.create_node("above", parameter_overrides=[Parameter("use_sim_time", value=True)])
say(sorted(name for name in listener.get_node_names() if name in ("above", "below")))
rclpy.spin_once(listener, timeout_sec=0.1)
again.get_logger().info("three")
spin()
rclpy.shutdown()
