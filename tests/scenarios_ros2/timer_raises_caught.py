"""An exception from a callback can be caught around rclpy.spin; then the node can be spun again."""

import rclpy
from scenario import P, begin, end_after, mark, say


def callback():
    global calls
    calls += 1
    mark("tick")
    if calls == 2:
        raise ValueError("in a callback")


calls = 0
rclpy.init()
node = rclpy.create_node("timer_raises_caught")
begin()
node.create_timer(P, callback)
end_after(4.5)
try:
    rclpy.spin(node)
except ValueError as error:
    say("caught", error, rclpy.ok())
rclpy.spin(node)
