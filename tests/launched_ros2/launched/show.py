"""Logs its names, its command line and its parameters."""

import os
import re
import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    node = Node("show", automatically_declare_parameters_from_overrides=True)
    words = [re.sub(r".*/(launch_params|config/).*", "FILE", word) for word in sys.argv[1:]]
    print("line", words, flush=True)
    print("name", node.get_fully_qualified_name(), flush=True)
    print("topic", node.create_publisher(String, "chatter", 1).topic_name, flush=True)
    for name, parameter in sorted(node._parameters.items()):
        value = parameter.value
        if name != "start_type_description_service" and (name, value) != ("use_sim_time", False):
            print("parameter", name, value if isinstance(value, (str, bool, int, float)) else list(value), flush=True)
    for name in ("COLOUR", "SHAPE"):
        if name in os.environ:
            print(name, os.environ[name], flush=True)
    node.get_logger().info("shown")
    node.destroy_node()
    rclpy.shutdown()
