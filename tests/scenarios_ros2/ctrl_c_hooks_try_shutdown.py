"""try_shutdown() after Ctrl-C raises nothing, and runs no hook: the context is down already."""

import rclpy
from scenario import P, begin, mark, say

rclpy.init()
node = rclpy.create_node("ctrl_c_hooks_try_shutdown")
rclpy.get_default_context().on_shutdown(lambda: say("hook"))
begin()
node.create_timer(P, lambda: mark("tick"))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
say("try_shutdown", rclpy.try_shutdown())
say("the end")
