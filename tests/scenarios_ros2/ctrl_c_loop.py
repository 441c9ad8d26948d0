"""Ctrl-C in a loop of the node's own that sleeps: KeyboardInterrupt; the context is down."""

import time

import rclpy
from scenario import P, begin, mark, say

rclpy.init()
node = rclpy.create_node("ctrl_c_loop")
begin()
try:
    while rclpy.ok():
        mark("pass")
        time.sleep(P)
except KeyboardInterrupt:
    mark("interrupted")
    say("ok", rclpy.ok())
say(rclpy.spin(node) if rclpy.ok() else "the end")
