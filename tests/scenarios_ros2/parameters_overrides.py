"""Parameters from the command line: their values, types and what an unsuitable one does."""

import sys

import rclpy
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.parameter import Parameter
from scenario import attempt, say

rclpy.init()
node = rclpy.create_node("parameters_overrides")
names = {"node": node, "Parameter": Parameter, "ParameterDescriptor": ParameterDescriptor}
for text in """
node.has_parameter('rate')
node.declare_parameter('rate', 2.0).value
node.declare_parameter('whole', 2.0)
node.declare_parameter('dynamic', 1.0, ParameterDescriptor(dynamic_typing=True)).value
node.declare_parameter('text', 'x').value
node.declare_parameter('list', [0]).value
node.declare_parameter('flag', False).value
node.declare_parameter('typed', Parameter.Type.STRING).value
node.declare_parameter('untyped', descriptor=ParameterDescriptor(dynamic_typing=True)).value
node.declare_parameter('ignored', 5, ignore_override=True).value
node.declare_parameter('other', 5).value
node.get_parameter('whole')
""".strip().splitlines():
    attempt(text, names)
allowed = rclpy.create_node(
    "allowed", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True
)
say(*(f"{name}={parameter.value}" for name, parameter in sorted(allowed.get_parameters_by_prefix("").items())))
say(allowed.get_parameter("rate").value, allowed.get_parameter("nonsuch").value)
say(sys.argv[1:])
