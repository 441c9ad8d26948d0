"""Ctrl-C in a loop of the node's own that sleeps: KeyboardInterrupt."""

import time

import rclpy
from scenario import P, begin, mark

rclpy.init()
node = rclpy.create_node("ctrl_c_loop")
begin()
try:
    while rclpy.ok():
        mark("pass")
        time.sleep(P)
except KeyboardInterrupt:
    mark("interrupted")
