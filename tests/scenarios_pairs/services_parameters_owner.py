"""Has a parameter that must not be negative; ends when it is set to 0."""

import rclpy
from rcl_interfaces.msg import SetParametersResult
from scenario import say, spin_for, spin_until


def check(parameters):
    return SetParametersResult(successful=parameters[0].value >= 0, reason="not below 0")


rclpy.init()
node = rclpy.create_node("owner")
node.declare_parameter("rate", 10.0)
node.add_on_set_parameters_callback(check)
spin_until(node, lambda: node.get_parameter("rate").value == 5.0)
say("was set")
spin_until(node, lambda: node.get_parameter("rate").value == 0.0)
spin_for(node, 1.0)
rclpy.shutdown()
