"""An executor takes coroutines, too, not only the functions that make them."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.task import Future
from scenario import P, say


async def adds(number):
    say("begun", number)
    return number + await future


async def fails():
    raise ValueError("in a coroutine")


rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(rclpy.create_node("executor_coroutines"))
future = Future()
first = executor.create_task(adds(1))
never = executor.create_task(adds(2))
say(first.done(), first.executing())
never.cancel()
say(never.done(), never.cancelled())
executor.spin_until_future_complete(first, timeout_sec=0.25 * P)
say(first.done(), first.executing())
late = executor.create_task(adds(3))
executor.spin_once(timeout_sec=0)
executor.spin_once(timeout_sec=0)
late.cancel()
future.set_result(40)
executor.spin_until_future_complete(first, timeout_sec=P)
say(first.result(), late.cancelled(), late.result())
failing = executor.create_task(fails())
try:
    executor.spin_until_future_complete(failing, timeout_sec=P)
except ValueError as error:
    say("raised", error)
