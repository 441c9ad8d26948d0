"""rclpy.spin_until_future_complete returns when the future is done, or after its timeout."""

import rclpy
from rclpy.task import Future
from scenario import P, begin, mark, say


def callback():
    global calls
    calls += 1
    mark("tick")
    if calls == 2:
        future.set_result("two")


calls = 0
future, never = Future(), Future()
rclpy.init()
node = rclpy.create_node("spin_until_future")
begin()
node.create_timer(P, callback)
say(rclpy.spin_until_future_complete(node, future), future.done(), future.result())
mark("done")
rclpy.spin_until_future_complete(node, never, timeout_sec=1.6 * P)
mark("timeout")
say(never.done(), never.cancelled())
rclpy.spin_until_future_complete(node, never, timeout_sec=0)
mark("at_once")
rclpy.spin_until_future_complete(node, future)
mark("done_before")
rclpy.shutdown()
