"""A timer made without autostart does not tick until it is reset; destroyed, it ticks no more."""

import rclpy
from scenario import P, after, begin, end_after, mark, say

rclpy.init()
node = rclpy.create_node("timer_reset_cancelled")
begin()
timer = node.create_timer(P, lambda: mark("tick"), autostart=False)
say("cancelled", timer.is_canceled(), timer.is_ready(), timer.time_until_next_call())
node.create_timer(2.5 * P, lambda: (mark("other"), timer.reset() if timer.is_canceled() else None))
after(6.2, lambda: say("destroyed", node.destroy_timer(timer)))
end_after(8)
rclpy.spin(node)
