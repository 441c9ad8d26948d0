"""A KeyboardInterrupt that a callback raises itself."""

import rclpy
from scenario import P, begin, mark, say


def callback():
    mark("tick")
    raise KeyboardInterrupt


rclpy.init()
node = rclpy.create_node("timer_interrupts")
begin()
node.create_timer(P, callback)
try:
    rclpy.spin(node)
finally:
    say("ok", rclpy.ok())
