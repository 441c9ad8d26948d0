"""A period of 0 or of a nanosecond: the callback is called without a pause."""

import rclpy
from scenario import begin, mark, say


def callback():
    global calls
    calls += 1
    if calls == 50:
        mark("soon")
        timer.cancel()


rclpy.init()
node = rclpy.create_node("timer_period_zero")
begin()
for period in (0, 1e-9):
    calls = 0
    timer = node.create_timer(period, callback)
    while calls < 50:
        rclpy.spin_once(node)
    say(timer.timer_period_ns, calls)
    node.destroy_timer(timer)
rclpy.shutdown()
