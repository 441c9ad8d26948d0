"""Ctrl-C in the documented idiom: a thread spins, the main sleeps on a Rate. Tracebacks, and perhaps an abort."""

import threading

import rclpy
from scenario import P, begin, mark, say

threading.excepthook = lambda args: say("in the thread:", args.exc_type.__name__)
rclpy.init()
node = rclpy.create_node("ctrl_c_rate_in_main")
begin()
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
rate = node.create_rate(1 / P)
try:
    while rclpy.ok():
        mark("pass")
        rate.sleep()
except KeyboardInterrupt:
    say("in main: KeyboardInterrupt")
    raise SystemExit(130)
