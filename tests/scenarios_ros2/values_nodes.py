"""Nodes that cannot be made, and what cannot be done before init or after shutdown."""

import warnings

import rclpy
from rclpy.node import Node
from scenario import attempt, say

warnings.simplefilter("ignore")  # a node that cannot be made complains of its logger, too
names = {"rclpy": rclpy, "Node": Node}
for text in """
rclpy.ok()
rclpy.create_node('early')
Node('early')
rclpy.shutdown()
rclpy.try_shutdown()
rclpy.init()
rclpy.ok()
rclpy.init()
rclpy.create_node('a b')
rclpy.create_node('5a')
rclpy.create_node('a/b')
rclpy.create_node('~a')
rclpy.create_node('a', namespace='b c')
rclpy.create_node('a', namespace='b/')
rclpy.create_node('a', namespace='/').get_fully_qualified_name()
rclpy.create_node('a', namespace='b').get_namespace()
rclpy.create_node('same').get_name()
rclpy.create_node()
Node()
Node('n', nonsense=True)
rclpy.create_node('n', nonsense=True)
rclpy.spin(None)
rclpy.spin()
rclpy.spin_once(5)
rclpy.get_default_context().ok()
rclpy.shutdown()
rclpy.ok()
rclpy.shutdown()
rclpy.try_shutdown()
rclpy.create_node('late')
""".strip().splitlines():
    attempt(text, names)
rclpy.init()
node = rclpy.create_node("again")
node.destroy_node()
names["node"] = node
for text in """
node.destroy_node()
node.get_name()
node.create_timer(1, print)
node.get_logger().info('x')
""".strip().splitlines():
    attempt(text, names)
rclpy.shutdown()
say("the end")
