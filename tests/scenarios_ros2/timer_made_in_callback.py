"""A timer that another timer makes counts from then."""

import rclpy
from scenario import P, begin, end_after, mark


def callback():
    global made
    mark("first")
    if made is None:
        made = node.create_timer(0.75 * P, lambda: mark("made"))


made = None
rclpy.init()
node = rclpy.create_node("timer_made_in_callback")
begin()
node.create_timer(P, callback)
end_after(4.4)
rclpy.spin(node)
