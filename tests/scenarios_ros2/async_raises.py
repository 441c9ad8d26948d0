"""An exception in an async callback, after it has awaited something."""

import rclpy
from rclpy.task import Future
from scenario import P, begin, mark


async def callback():
    mark("waits")
    timer.cancel()
    await future
    mark("raises")
    raise ValueError("after an await")


rclpy.init()
node = rclpy.create_node("async_raises")
future = Future()
begin()
timer = node.create_timer(P, callback)
setter = node.create_timer(2.5 * P, lambda: (setter.cancel(), future.set_result(None)))
rclpy.spin(node)
