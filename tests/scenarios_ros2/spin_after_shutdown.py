"""Spinning in every way after the shutdown."""

import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.task import Future
from scenario import attempt

rclpy.init()
node = rclpy.create_node("spin_after_shutdown")
single, multi = SingleThreadedExecutor(), MultiThreadedExecutor(2)
single.add_node(node)
rclpy.shutdown()
names = {"rclpy": rclpy, "node": node, "single": single, "multi": multi, "Future": Future}
for text in """
single.spin()
single.spin_once()
single.spin_once(timeout_sec=0)
single.spin_until_future_complete(Future(), timeout_sec=0.1)
multi.add_node(node)
multi.spin()
single.shutdown()
""".strip().splitlines():
    attempt(text, names)
