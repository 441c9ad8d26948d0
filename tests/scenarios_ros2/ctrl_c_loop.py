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
try:
    rclpy.spin(node)
    say("spun")
    rclpy.spin_once(node, timeout_sec=P)
except BaseException as error:
    say(type(error).__name__, error)
