"""The documented idiom: a thread spins, the main sleeps on a Rate; each pass takes 0.3 periods."""

import os
import threading

import rclpy
from scenario import P, begin, block, mark

rclpy.init()
node = rclpy.create_node("rate_main_spin_in_thread")
begin()
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
rate = node.create_rate(1 / P)
for _ in range(6):
    mark("pass")
    block(0.3)
    rate.sleep()
mark("end")
os._exit(0)
