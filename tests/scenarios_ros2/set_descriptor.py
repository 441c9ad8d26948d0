"""A parameter's descriptor can be replaced."""

import rclpy
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, ParameterValue
from rclpy.exceptions import (
    InvalidParameterValueException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
)
from scenario import say

rclpy.init()
node = rclpy.create_node("set_descriptor")
node.declare_parameter("count", 5)
node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))


def attempt(name, alternative=None, **fields):
    try:
        say(name, node.set_descriptor(name, ParameterDescriptor(**fields), alternative))
    except (InvalidParameterValueException, ParameterImmutableException, ParameterNotDeclaredException) as error:
        say(type(error).__name__, error)
    if node.has_parameter(name):
        say(node.get_parameter(name).value, node.describe_parameter(name))


low = [IntegerRange(from_value=0, to_value=3, step=1)]
attempt("count", type=2, description="of ticks")
attempt("count", type=2, integer_range=low)
attempt("count", ParameterValue(type=2, integer_value=2), type=2, integer_range=low)
attempt(
    "count", ParameterValue(type=2, integer_value=9), type=2, integer_range=[IntegerRange(from_value=5, to_value=7)]
)
attempt("count", dynamic_typing=True)
attempt("fixed")
attempt("nobody")
rclpy.shutdown()
