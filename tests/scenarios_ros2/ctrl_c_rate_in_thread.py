"""Ctrl-C with the spin in main and a Rate loop in a daemon thread, the way that ends well."""

import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import P, begin, mark, say


def loop():
    while rclpy.ok():
        mark("pass")
        rate.sleep()


rclpy.init()
node = rclpy.create_node("ctrl_c_rate_in_thread")
begin()
rate = node.create_rate(1 / P)
threading.Thread(target=loop, daemon=True).start()
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
say("spun", rclpy.ok())
