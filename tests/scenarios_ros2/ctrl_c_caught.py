"""Ctrl-C in rclpy.spin, caught in the way that holds for every distribution."""

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import P, begin, mark, say

rclpy.init()
node = rclpy.create_node("ctrl_c_caught")
begin()
node.create_timer(P, lambda: mark("tick"))
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException) as error:
    say(type(error).__name__)
finally:
    say("ok", rclpy.ok())
    rclpy.try_shutdown()
say("the end")
