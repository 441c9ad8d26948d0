"""A timer that another one resets before it is due never ticks; once left alone, it ticks a period later."""

import rclpy
from scenario import P, begin, end_after, mark


def reset():
    global resets
    resets += 1
    mark("reset")
    timer.reset()
    if resets == 6:
        resetter.cancel()


resets = 0
rclpy.init()
node = rclpy.create_node("timer_reset")
begin()
timer = node.create_timer(P, lambda: mark("tick"))
resetter = node.create_timer(0.6 * P, reset)
end_after(7.2)
rclpy.spin(node)
