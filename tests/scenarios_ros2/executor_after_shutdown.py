"""An executor that was shut down is used again, and what it should have done."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.task import Future


def attempt(what, call):
    try:
        print(what, "->", call())
    except Exception as error:
        print(what, "->", type(error).__name__, str(error)[:150])


rclpy.init()
for kind in (SingleThreadedExecutor,):
    node = rclpy.create_node("alone")
    node.create_timer(0.1, lambda: print("tick"))
    executor = kind()
    executor.add_node(node)
    executor.spin_once()
    print(kind.__name__, executor.shutdown())
    attempt("spin_once", lambda: executor.spin_once(timeout_sec=0.3))
    attempt("spin", lambda: executor.spin())
    attempt("until", lambda: executor.spin_until_future_complete(Future(), 0.3))
    attempt("once until", lambda: executor.spin_once_until_future_complete(Future(), 0.3))
    attempt("add_node", lambda: executor.add_node(rclpy.create_node("more")))
    attempt("remove_node", lambda: executor.remove_node(node))
    attempt("create_task", lambda: executor.create_task(lambda: 1).done())
    attempt("wake", lambda: executor.wake())
    attempt("nodes", lambda: len(executor.get_nodes()))
    attempt("shutdown", lambda: executor.shutdown())
    attempt("rclpy.spin_once", lambda: rclpy.spin_once(node, executor=executor, timeout_sec=0.3))
    attempt("node again", lambda: rclpy.spin_once(node, timeout_sec=0.3))
    node.destroy_node()
