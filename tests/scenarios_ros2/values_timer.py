"""Periods and callbacks that are none."""

import math

import rclpy
from scenario import attempt

rclpy.init()
node = rclpy.create_node("values_timer")
names = {"node": node, "math": math}
for text in """
node.create_timer(-1, print)
node.create_timer(-0.0, print).timer_period_ns
node.create_timer(math.nan, print)
node.create_timer(math.inf, print)
node.create_timer(None, print)
node.create_timer(1)
node.create_timer()
node.create_timer(1, None).callback
node.create_timer(1, print).callback
node.create_timer(0.1, print).timer_period_ns
node.create_timer(1 / 3, print).timer_period_ns
node.create_timer(True, print).timer_period_ns
node.create_timer(1.1, print).callback_group is node.default_callback_group
type(node.create_timer(1, print)).__name__
len(list(node.timers))
node.create_rate(0)
node.create_rate(-1)
node.create_rate('1')
node.create_rate(math.inf)
node.create_rate(math.nan)
node.create_rate(1e10)
type(node.create_rate(10)).__name__
node.destroy_timer(None)
node.destroy_timer(print)
node.destroy_rate(node.create_rate(10))
""".strip().splitlines():
    attempt(text, names)
