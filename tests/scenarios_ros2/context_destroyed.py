"""What a context that was destroyed answers, and what is in it."""

import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from scenario import attempt, say

context = Context()
context.destroy()
say(context.ok())
rclpy.init(context=context)
node = rclpy.create_node("context_destroyed", context=context)
executor = SingleThreadedExecutor(context=context)
executor.add_node(node)
context.destroy()
names = {"context": context, "executor": executor, "node": node, "rclpy": rclpy}
for text in """
context.ok()
context.get_domain_id()
context.on_shutdown(print)
context.shutdown()
context.try_shutdown()
rclpy.ok(context=context)
rclpy.try_shutdown(context=context)
executor.spin_once(timeout_sec=0.1)
node.create_timer(1, print)
rclpy.create_node('other', context=context)
context.init()
context.destroy()
""".strip().splitlines():
    attempt(text, names)
