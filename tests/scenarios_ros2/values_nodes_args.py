"""What a node's own command line, and a shared one, do to its name."""

import rclpy
from scenario import attempt, say

rclpy.init(args=["--ros-args", "-r", "__ns:=/shared", "-r", "first:__node:=renamed", "-p", "second:a:=5", "-p", "b:=6"])
first = rclpy.create_node("first")
second = rclpy.create_node("second", namespace="own")
third = rclpy.create_node("third", use_global_arguments=False)
fourth = rclpy.create_node("fourth", cli_args=["--ros-args", "-r", "__node:=by_args", "-p", "a:=7"])
for node in (first, second, third, fourth):
    say(node.get_fully_qualified_name(), node.get_logger().name)
    for name in "ab":
        attempt("node.declare_parameter(name, 0).value", {"node": node, "name": name})
