"""While an async callback awaits, its group is taken: a timer of the same group waits, another group's does not."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.task import Future
from scenario import P, begin, end_after, mark


async def waiting():
    mark("waits")
    timer.cancel()
    await future
    mark("went_on")


def setting():
    mark("sets")
    future.set_result(None)
    setter.cancel()


rclpy.init()
node = rclpy.create_node("async_groups")
future = Future()
begin()
timer = node.create_timer(P, waiting)
setter = node.create_timer(3.3 * P, setting, MutuallyExclusiveCallbackGroup())
node.create_timer(0.8 * P, lambda: mark("beside"))
end_after(6.7)
rclpy.spin(node)
