"""Parameters: declared, read, set; their types and what goes wrong."""

import sys

import rclpy
from rclpy.parameter import Parameter, parameter_value_to_python
from scenario import attempt

rclpy.init(args=sys.argv)
node = rclpy.create_node("values_parameters")
names = {"node": node, "Parameter": Parameter, "to_python": parameter_value_to_python}
for text in """
node.declare_parameter('rate', 2.0).value
node.declare_parameter('count', 3)
node.declare_parameter('text', 'word').value
node.declare_parameter('yes', True).type_
node.declare_parameter('bytes', [b'a', b'b']).type_
node.declare_parameter('list', [1, 2, 3]).value
node.declare_parameter('floats', [1.0, 2.0]).value
node.declare_parameter('strings', ['a', 'b']).value
node.declare_parameter('empty', []).type_
node.declare_parameter('mixed', [1, 'a'])
node.declare_parameter('a.b.c', 1).name
node.declare_parameter('typed', Parameter.Type.DOUBLE).value
node.declare_parameter('rate', 1.0)
node.declare_parameter('')
node.declare_parameter(5)
node.get_parameter('rate').value
node.get_parameter('rate').get_parameter_value().double_value
node.get_parameter('count').get_parameter_value().integer_value
node.get_parameter('count')
str(node.get_parameter('text'))
node.get_parameter('list').value
node.get_parameter('nonsuch')
node.get_parameter_or('nonsuch', Parameter('nonsuch', value=5)).value
node.get_parameter_or('rate').value
node.get_parameters(['rate', 'count'])
node.get_parameters(['rate', 'nonsuch'])
node.has_parameter('rate'), node.has_parameter('nonsuch')
node.set_parameters([Parameter('rate', value=5.0)])
node.get_parameter('rate').value
node.set_parameters([Parameter('rate', Parameter.Type.INTEGER, 5)])
node.set_parameters([Parameter('rate', value='fast')])[0].reason
node.get_parameter('rate').value
node.set_parameters([Parameter('nonsuch', value=5)])
node.set_parameters_atomically([Parameter('count', value=5), Parameter('rate', value=1.5)])
node.get_parameters_by_prefix('a')
node.get_parameters_by_prefix('nonsuch')
node.undeclare_parameter('count')
node.has_parameter('count')
node.undeclare_parameter('count')
node.declare_parameters('', [('x', 1), ('y', 2.0)])
node.declare_parameters('robot', [('speed', 0.5)])[0].name
Parameter('a', value=1)
Parameter('a', Parameter.Type.DOUBLE, 1)
Parameter('a', Parameter.Type.STRING, 'b').to_parameter_msg()
Parameter.Type.from_parameter_value([1, 2])
Parameter.Type.from_parameter_value({})
Parameter('a').type_
Parameter('a', value=1) == Parameter('a', value=1)
to_python(Parameter('a', value=[1.0, 2.0]).get_parameter_value())
node.get_parameter('use_sim_time').value
node.get_parameter_type('rate')
node.describe_parameter('rate').type
node.describe_parameter('nonsuch')
""".strip().splitlines():
    attempt(text, names)
print(sys.argv[1:])
