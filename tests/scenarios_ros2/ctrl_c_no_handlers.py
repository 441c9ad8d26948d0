"""Without rclpy's signal handlers, Ctrl-C is Python's own: the spin does not notice until a callback runs."""

import rclpy
from rclpy.signals import SignalHandlerOptions
from scenario import P, begin, mark, say

rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
node = rclpy.create_node("ctrl_c_no_handlers")
begin()
node.create_timer(P, lambda: mark("tick"))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    mark("caught")
    say("ok", rclpy.ok())
    rclpy.shutdown()
    say("ok", rclpy.ok())
