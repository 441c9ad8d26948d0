"""A node in a context of its own; shutting down one context leaves the other."""

import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from scenario import P, attempt, begin, mark, say


def callback():
    mark("own")
    context.shutdown()


context = Context()
context.init()
rclpy.init()
first, own = rclpy.create_node("first"), rclpy.create_node("own", context=context)
context.on_shutdown(lambda: say("hook of its own"))
begin()
own.create_timer(1.5 * P, callback)
first.create_timer(P, lambda: mark("first"))
executor = SingleThreadedExecutor(context=context)
say(executor.add_node(own))
executor.spin()
mark("spun")
say(context.ok(), rclpy.ok(), rclpy.ok(context=context))
for _ in range(2):
    rclpy.spin_once(first)
names = {"context": context, "rclpy": rclpy, "Context": Context, "own": own, "executor": executor, "P": P}
for text in """
context.shutdown()
context.try_shutdown()
executor.spin_once(timeout_sec=0.1)
executor.spin_once(timeout_sec=0)
executor.spin_once()
executor.spin()
own.create_timer(P, print)
own.create_rate(1)
own.create_guard_condition(print)
Context().ok()
Context().shutdown()
rclpy.create_node('n', context=Context())
rclpy.spin_once(rclpy.create_node('n'), executor=None, timeout_sec=0)
""".strip().splitlines():
    attempt(text, names)
