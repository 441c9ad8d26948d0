"""rclpy.shutdown() in another thread while the main spins."""

import rclpy
from scenario import P, after, begin, mark, say

rclpy.init()
node = rclpy.create_node("shutdown_in_thread")
rclpy.get_default_context().on_shutdown(lambda: mark("hook"))
begin()
node.create_timer(P, lambda: mark("tick"))
after(2.5, rclpy.shutdown)
try:
    rclpy.spin(node)
    say("spun")
except Exception as error:
    say(type(error).__name__, error.args)
mark("end_of_main")
