"""Hooks of the context do not run at Ctrl-C; the finally clause does, and shutdown() then raises."""

import atexit

import rclpy
from scenario import P, begin, mark, say

rclpy.init()
node = rclpy.create_node("ctrl_c_hooks")
rclpy.get_default_context().on_shutdown(lambda: say("hook"))
atexit.register(say, "at exit")
begin()
node.create_timer(P, lambda: mark("tick"))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    say("caught", rclpy.ok())
finally:
    node.destroy_node()
    rclpy.shutdown()
