"""Functions and coroutines that an executor is given run when it spins."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.task import Future
from scenario import P, begin, mark, say


def function(*words):
    mark("function")
    return " ".join(words)


async def coroutine(future):
    mark("begun")
    value = await future
    mark("went_on")
    return value


async def fails():
    raise ValueError("in a coroutine")


rclpy.init()
node = rclpy.create_node("executor_tasks")
begin()
executor = SingleThreadedExecutor()
executor.add_node(node)
future = Future(executor=executor)
tasks = [executor.create_task(function, "a", "b"), executor.create_task(coroutine, future)]
timer = node.create_timer(1.5 * P, lambda: (timer.cancel(), future.set_result(42)))
for task in tasks:
    executor.spin_until_future_complete(task, timeout_sec=4 * P)
    say(task.done(), task.result(), task.exception())
mark("done")
failing = executor.create_task(fails)
try:
    executor.spin_until_future_complete(failing, timeout_sec=P)
except ValueError as error:
    say("raised", error)
say(failing.done(), failing.exception())
executor.spin_once(timeout_sec=0.5 * P)
mark("end_of_main")
