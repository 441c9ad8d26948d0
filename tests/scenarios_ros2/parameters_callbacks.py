"""What is no callback of parameters: some are refused when they are added, others when they should be called."""

import rclpy
from rclpy.parameter import Parameter
from scenario import attempt

rclpy.init()
node = rclpy.create_node("parameters_callbacks")
node.declare_parameter("rate", 1)
names = {"node": node, "Parameter": Parameter}
for text in """
node.add_on_set_parameters_callback(5)
node.remove_on_set_parameters_callback(5)
node.remove_pre_set_parameters_callback(5)
node.remove_post_set_parameters_callback(5)
node.add_post_set_parameters_callback(5)
node.set_parameters([Parameter('rate', value=2)])
node.get_parameter('rate').value
node.remove_post_set_parameters_callback(5)
node.add_pre_set_parameters_callback(6)
node.set_parameters([Parameter('rate', value=3)])
node.remove_pre_set_parameters_callback(6)
node.add_pre_set_parameters_callback(lambda parameters: [])
node.set_parameters([Parameter('rate', value=4)])
node.add_on_set_parameters_callback(lambda parameters: None)
node.get_parameter('rate').value
""".strip().splitlines():
    attempt(text, names)
