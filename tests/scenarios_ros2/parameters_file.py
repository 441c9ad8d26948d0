"""Parameters from a file, for this node and for all."""

import os
import sys

import rclpy
from scenario import say

rclpy.init(args=[*sys.argv, "--ros-args", "--params-file", os.path.join(os.path.dirname(__file__), "params.yaml")])
node = rclpy.create_node("parameters_file", automatically_declare_parameters_from_overrides=True)
for name in ("rate", "text", "robot.names", "everywhere"):
    say(name, node.get_parameter(name).value)
