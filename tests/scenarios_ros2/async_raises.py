"""An exception in an async callback, after it has awaited something, ends nothing and is not heard of."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.task import Future
from scenario import P, begin, end_after, mark


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
node.create_timer(0.9 * P, lambda: mark("other"), MutuallyExclusiveCallbackGroup())
timer = node.create_timer(P, callback)
setter = node.create_timer(
    2.5 * P, lambda: (setter.cancel(), future.set_result(None)), MutuallyExclusiveCallbackGroup()
)
end_after(4)
rclpy.spin(node)
