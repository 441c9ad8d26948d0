"""A timer's callback that awaits a future which another timer sets: the executor continues meanwhile."""

import rclpy
from rclpy.task import Future
from scenario import P, begin, end_after, mark, say

future = Future()


async def waiting():
    mark("waits")
    timer.cancel()
    say("got", await future)
    mark("went_on")


def setting():
    mark("sets")
    future.set_result(42)
    setter.cancel()


rclpy.init()
node = rclpy.create_node("async_callback")
begin()
timer = node.create_timer(P, waiting)
setter = node.create_timer(2.5 * P, setting)
node.create_timer(1.4 * P, lambda: mark("other"))
end_after(6.5)
rclpy.spin(node)
