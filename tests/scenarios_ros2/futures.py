"""Futures: results, exceptions, callbacks, cancelling."""

from rclpy.task import Future, Task
from scenario import attempt, say

future = Future()
names = {"future": future, "Future": Future, "Task": Task, "say": say}
future.add_done_callback(lambda done: say("callback", done is future, done.done(), done.result()))
for text in """
future.done(), future.cancelled(), future.result(), future.exception()
future.set_result(1)
future.done(), future.result()
future.set_result(2)
future.result()
future.add_done_callback(lambda done: say("late callback", done.result()))
future.cancel()
future.cancelled(), future.done(), future.result()
""".strip().splitlines():
    attempt(text, names)
names["future"] = future = Future()
for text in """
future.set_exception(ValueError('wrong'))
future.done(), future.exception()
future.result()
""".strip().splitlines():
    attempt(text, names)
names["future"] = future = Future()
for text in """
future.cancel()
future.cancelled(), future.done(), future.result()
future.set_result(5)
future.cancelled(), future.done(), future.result()
""".strip().splitlines():
    attempt(text, names)
names["task"] = task = Task(lambda a, b=0: a + b, (1,), {"b": 2})
for text in """
task.done(), task.executing()
task()
task.done(), task.result()
task()
""".strip().splitlines():
    attempt(text, names)
