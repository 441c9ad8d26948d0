"""Ctrl-C in a loop of rclpy.spin_once with a timeout."""

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import P, begin, mark, say

rclpy.init()
node = rclpy.create_node("ctrl_c_spin_once")
begin()
try:
    while rclpy.ok():
        mark("pass")
        rclpy.spin_once(node, timeout_sec=P)
except (KeyboardInterrupt, ExternalShutdownException) as error:
    mark("caught")
    say(type(error).__name__)
