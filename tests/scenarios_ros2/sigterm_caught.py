"""SIGTERM, caught in the way that holds for every distribution."""

import os
import signal

import rclpy
from rclpy.executors import ExternalShutdownException
from scenario import P, after, begin, mark, say

rclpy.init()
node = rclpy.create_node("sigterm_caught")
begin()
node.create_timer(P, lambda: mark("tick"))
after(2.5, lambda: os.kill(os.getpid(), signal.SIGTERM))
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException) as error:
    mark("caught")
    say(type(error).__name__, error.args, rclpy.ok())
rclpy.try_shutdown()
