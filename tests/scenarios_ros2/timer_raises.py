"""An exception in a callback leaves rclpy.spin and ends the node."""

import rclpy
from scenario import P, begin, mark


def callback():
    mark("tick")
    raise ValueError("in a callback")


rclpy.init()
node = rclpy.create_node("timer_raises")
begin()
node.create_timer(P, callback)
node.create_timer(1.5 * P, lambda: mark("other"))
rclpy.spin(node)
