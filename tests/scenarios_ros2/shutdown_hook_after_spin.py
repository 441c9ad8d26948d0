"""The global executor goes at shutdown and takes an earlier hook with it: the hook that was added next is missed."""

import rclpy
from scenario import say

rclpy.init()
node = rclpy.create_node("node")
context = rclpy.get_default_context()
context.on_shutdown(lambda: say("before the first spin"))
node.create_timer(0.5, lambda: say("tick"))
rclpy.spin_once(node)
context.on_shutdown(lambda: say("next"))
context.on_shutdown(lambda: say("last"))
rclpy.spin_once(node)
rclpy.shutdown()
say("end")
