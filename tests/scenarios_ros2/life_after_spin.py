"""How long a node stays that was spun, kept nowhere, and never destroyed."""

import gc

import rclpy
from rclpy.executors import SingleThreadedExecutor
from scenario import say

rclpy.init()
watch = rclpy.create_node("watch")


def leave(steps, raises):
    node = rclpy.create_node("left")
    node.create_timer(0.05, lambda: None)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    if "spin" in steps:
        executor.spin_once(0.5)
    if "shut down" in steps:
        executor.shutdown()
    if "remove" in steps:
        executor.remove_node(node)
    if raises:
        raise ValueError


gc.disable()
for steps in ([], ["spin"], ["spin", "remove"], ["spin", "shut down"], ["shut down"]):
    for raises in (False, True):
        try:
            leave(steps, raises)
        except ValueError:
            pass
        before = watch.get_node_names()
        gc.collect()
        say(steps, raises, before, watch.get_node_names())
rclpy.shutdown()
