"""A handler of the node's own, installed after init, replaces rclpy's: nothing ends at Ctrl-C."""

import signal

import rclpy
from scenario import P, begin, end_after, mark, say


def handle(number, frame):
    mark("handled")
    say("ok", rclpy.ok())


rclpy.init()
signal.signal(signal.SIGINT, handle)
node = rclpy.create_node("ctrl_c_own_handler")
begin()
node.create_timer(P, lambda: mark("tick"))
end_after(7.5)
rclpy.spin(node)
