"""The services by which a node's parameters are read and set."""

import rclpy
from rcl_interfaces.msg import Parameter, ParameterValue
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from scenario import say


def ask(kind, name, **fields):
    client = node.create_client(kind, f"services_parameters/{name}")
    future = client.call_async(kind.Request(**fields))
    rclpy.spin_until_future_complete(node, future, timeout_sec=2)
    say(name, future.result())


def parameter(name, **value):
    return Parameter(name=name, value=ParameterValue(**value))


rclpy.init()
node = rclpy.create_node("services_parameters")
node.declare_parameter("rate", 10.0)
node.declare_parameter("deep.count", 3)
ask(ListParameters, "list_parameters", depth=1)
ask(ListParameters, "list_parameters", prefixes=["deep"])
ask(GetParameters, "get_parameters", names=["rate", "deep.count"])
ask(GetParameters, "get_parameters", names=["rate", "nonsuch"])
ask(GetParameterTypes, "get_parameter_types", names=["rate", "use_sim_time"])
ask(DescribeParameters, "describe_parameters", names=["rate"])
changes = [parameter("rate", type=3, double_value=5.0), parameter("deep.count", type=4, string_value="x")]
ask(SetParameters, "set_parameters", parameters=changes)
ask(SetParameters, "set_parameters", parameters=[parameter("nonsuch", type=2, integer_value=1)])
ask(SetParametersAtomically, "set_parameters_atomically", parameters=changes)
ask(SetParametersAtomically, "set_parameters_atomically", parameters=[parameter("rate", type=3, double_value=7.0)])
say(node.get_parameter("rate").value, node.get_parameter("deep.count").value)
rclpy.shutdown()
