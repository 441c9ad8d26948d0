"""A timer whose node is not spun does not tick; when the spin begins, it ticks at once, once, and then on its grid."""

import rclpy
from scenario import P, begin, end_after, mark, until

rclpy.init()
node = rclpy.create_node("timer_late_spin")
begin()
node.create_timer(P, lambda: mark("tick"))
until(3.5)
mark("spin")
end_after(3.2)
rclpy.spin(node)
