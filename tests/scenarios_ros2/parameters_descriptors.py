"""Parameters that are read-only, in a range, or described."""

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.parameter import Parameter
from scenario import attempt

rclpy.init()
node = rclpy.create_node("parameters_descriptors")
node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True, description="never changes"))
whole = IntegerRange(from_value=0, to_value=10, step=2)
node.declare_parameter("whole", 4, ParameterDescriptor(integer_range=[whole]))
real = FloatingPointRange(from_value=0.0, to_value=1.0, step=0.0)
node.declare_parameter("real", 0.5, ParameterDescriptor(floating_point_range=[real]))
names = {"node": node, "Parameter": Parameter, "ParameterDescriptor": ParameterDescriptor, "real": real}
for text in """
node.set_parameters([Parameter('fixed', value=2)])[0]
node.set_parameters([Parameter('whole', value=6)])[0]
node.set_parameters([Parameter('whole', value=12)])[0]
node.set_parameters([Parameter('whole', value=5)])[0]
node.set_parameters([Parameter('real', value=1.0)])[0]
node.set_parameters([Parameter('real', value=1.1)])[0]
node.get_parameter('whole').value, node.get_parameter('real').value
node.describe_parameter('fixed').description
node.undeclare_parameter('fixed')
node.declare_parameter('outside', 2.0, ParameterDescriptor(floating_point_range=[real]))
node.has_parameter('outside')
""".strip().splitlines():
    attempt(text, names)
