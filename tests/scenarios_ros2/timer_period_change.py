"""A new period: the call that is already due keeps its time."""

import rclpy
from scenario import P, begin, end_after, mark, say


def callback():
    global calls
    calls += 1
    mark("tick")
    if calls == 2:
        timer.timer_period_ns = int(2 * P * 1e9)
        say(timer.timer_period_ns)
    if calls == 4:
        timer.timer_period_ns = 0.5 * P * 1e9
        say(timer.timer_period_ns)


calls = 0
rclpy.init()
node = rclpy.create_node("timer_period_change")
begin()
timer = node.create_timer(P, callback)
end_after(9.25)
rclpy.spin(node)
