"""SIGTERM while a callback runs: it continues to its end, then spin returns."""

import os
import signal

import rclpy
from scenario import P, after, begin, block, mark, say


def callback():
    mark("tick")
    block(2)
    mark("ended")
    say("ok", rclpy.ok())


rclpy.init()
node = rclpy.create_node("sigterm_blocked")
begin()
node.create_timer(P, callback)
after(2.2, lambda: os.kill(os.getpid(), signal.SIGTERM))
rclpy.spin(node)
mark("spun")
