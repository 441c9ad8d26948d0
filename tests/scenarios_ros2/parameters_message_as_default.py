"""A parameter declared with a message for a default: that says only the type, and an override has to give the value."""

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, ParameterValue
from rclpy.parameter import Parameter
from scenario import say

rclpy.init()
overrides = [Parameter("rate", value=10.0), Parameter("name", value="left"), Parameter("any", value=3)]
node = rclpy.create_node("parameters_message_as_default", parameter_overrides=overrides)


def declare(name, value, descriptor):
    try:
        parameter = node.declare_parameter(name, value, descriptor)
    except Exception as error:
        say(name, type(error).__name__, error)
    else:
        say(name, parameter.type_.name, parameter.value)


declare("rate", ParameterValue(type=3, double_value=2.5), ParameterDescriptor())
declare("name", ParameterValue(type=2, integer_value=4), ParameterDescriptor())
declare("any", ParameterValue(), ParameterDescriptor(dynamic_typing=True))
declare("unset", ParameterValue(), ParameterDescriptor())
declare("other", ParameterValue(type=2, integer_value=4), ParameterDescriptor())
rclpy.shutdown()
