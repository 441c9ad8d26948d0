"""The names of parameters by their prefixes, and waiting for a node."""

import rclpy
from scenario import attempt, begin, mark

rclpy.init()
node = rclpy.create_node("n", namespace="x")
for name in ("a", "a.b", "a.b.c", "a.b.d", "ab.c", "z.y.x.w"):
    node.declare_parameter(name, 1)
names = {"node": node}
for text in """
node.list_parameters([], 0)
node.list_parameters([], 1)
node.list_parameters([], 2)
node.list_parameters(['a'], 0)
node.list_parameters(['a'], 1)
node.list_parameters(['a.b', 'z'], 1)
node.list_parameters(['a.b', 'z'], 2)
node.list_parameters(['nope'], 0)
node.list_parameters([''], 0)
node.list_parameters(['a.'], 0)
node.list_parameters(('a',), 0)
node.list_parameters([5], 0)
node.list_parameters([], 1.0)
node.list_parameters([], -1)
""".strip().splitlines():
    attempt(text, names)
begin()
for text in """
node.wait_for_node('x/n', 1.0)
node.wait_for_node('/x/n', 1.0)
node.wait_for_node('n', 0.35)
node.wait_for_node('x/n', 0)
node.wait_for_node('x/n', -1)
node.wait_for_node(5, 1)
node.wait_for_node('x/n', 'x')
""".strip().splitlines():
    attempt(text, names)
    mark("waited")
rclpy.shutdown()
