"""A handler of the node's own that shuts down; installed after init, it replaces Python's."""

import signal

import rclpy
from scenario import P, begin, mark, say


def handle(number, frame):
    mark("handled")
    say("ok", rclpy.ok())


rclpy.init()
signal.signal(signal.SIGINT, handle)
node = rclpy.create_node("ctrl_c_own_handler")
begin()
node.create_timer(P, lambda: mark("tick"))
try:
    rclpy.spin(node)
    say("spun")
except BaseException as error:
    say(type(error).__name__)
