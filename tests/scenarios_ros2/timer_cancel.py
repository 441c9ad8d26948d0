"""A timer that is cancelled in its third call ticks no more, until it is reset."""

import rclpy
from scenario import P, after, begin, end_after, mark, say


def callback():
    global calls
    calls += 1
    mark("tick")
    if calls == 3:
        timer.cancel()
        say("cancelled", timer.is_canceled(), timer.is_ready())


def resume():
    mark("reset")
    timer.reset()
    say("cancelled", timer.is_canceled())


calls = 0
rclpy.init()
node = rclpy.create_node("timer_cancel")
begin()
timer = node.create_timer(P, callback)
after(5.5, resume)
end_after(9)
rclpy.spin(node)
