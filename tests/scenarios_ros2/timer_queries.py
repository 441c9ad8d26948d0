"""What a timer says of itself, outside of a spin and in its callback."""

import rclpy
from scenario import P, begin, end_after, mark, say, until


def callback():
    mark("tick")
    mark("next", timer.time_until_next_call() / 1e9)
    mark("last", timer.time_since_last_call() / 1e9)
    say(timer.is_ready(), timer.is_canceled())
    timer.cancel()
    say(timer.time_until_next_call(), timer.is_canceled())


rclpy.init()
node = rclpy.create_node("timer_queries")
begin()
timer = node.create_timer(P, callback)
say(timer.timer_period_ns, type(timer.timer_period_ns).__name__, timer.clock.clock_type)
mark("next", timer.time_until_next_call() / 1e9)
mark("last", timer.time_since_last_call() / 1e9)
say(timer.is_ready())
until(1.6)
mark("overdue", timer.time_until_next_call() / 1e9)
say(timer.is_ready())
end_after(2)
rclpy.spin(node)
