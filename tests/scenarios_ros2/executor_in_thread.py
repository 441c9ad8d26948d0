"""An executor that spins in a thread, while the main does something else; a node is removed and added again."""

import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import P, begin, mark, say, until

rclpy.init()
node = rclpy.create_node("executor_in_thread")
begin()
node.create_timer(P, lambda: mark("tick"))
executor = SingleThreadedExecutor()
executor.add_node(node)
thread = threading.Thread(target=executor.spin, daemon=True)
thread.start()
until(2.5)
executor.remove_node(node)
say("removed", len(executor.get_nodes()))
until(4.5)
say(executor.add_node(node))
mark("added")
until(6.6)
say(executor.shutdown())
thread.join()
mark("joined")
say("ok", rclpy.ok())
