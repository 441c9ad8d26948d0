"""Names as the node sees them, for the command line that it was given."""

import sys

import rclpy
from scenario import attempt

rclpy.init()
node = rclpy.create_node("values_names")
other = rclpy.create_node("other", namespace="deep/down")
names = {"node": node, "other": other, "rclpy": rclpy, "sys": sys}
for text in """
node.get_name()
node.get_namespace()
node.get_fully_qualified_name()
node.get_logger().name
other.get_fully_qualified_name()
other.get_logger().name
node.resolve_topic_name('a')
node.resolve_topic_name('/a')
node.resolve_topic_name('~/a')
node.resolve_topic_name('~')
node.resolve_topic_name('chatter')
node.resolve_topic_name('chatter', only_expand=True)
node.resolve_topic_name('')
node.resolve_topic_name('a/')
node.resolve_topic_name('a//b')
node.resolve_topic_name('5a')
node.resolve_topic_name('a b')
node.resolve_topic_name('{node}/a')
other.resolve_topic_name('a')
other.resolve_topic_name('~/a')
node.get_clock().clock_type
node.context is rclpy.get_default_context()
node.executor
rclpy.utilities.remove_ros_args(sys.argv)[1:]
rclpy.utilities.remove_ros_args(['x', 'a', '--ros-args', '-r', 'b:=c', '--', 'd'])
sys.argv[1:]
""".strip().splitlines():
    attempt(text, names)
node.get_logger().info("a line")
other.get_logger().info("a line")
