"""SIGTERM in rclpy.spin: ExternalShutdownException."""

import os
import signal

import rclpy
from scenario import P, after, begin, mark

rclpy.init()
node = rclpy.create_node("sigterm_spin")
begin()
node.create_timer(P, lambda: mark("tick"))
after(2.5, lambda: os.kill(os.getpid(), signal.SIGTERM))
rclpy.spin(node)
