"""Reads and sets the parameters of a node in another process, by its services."""

import rclpy
from rcl_interfaces.msg import Parameter, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParameters
from scenario import say

rclpy.init()
node = rclpy.create_node("asker")


def ask(kind, name, **fields):
    client = node.create_client(kind, f"/owner/{name}")
    client.wait_for_service()
    future = client.call_async(kind.Request(**fields))
    rclpy.spin_until_future_complete(node, future)
    say(future.result())


ask(GetParameters, "get_parameters", names=["rate"])
for rate in (5.0, -1.0, 0.0):
    change = Parameter(name="rate", value=ParameterValue(type=3, double_value=rate))
    ask(SetParameters, "set_parameters", parameters=[change])
rclpy.shutdown()
