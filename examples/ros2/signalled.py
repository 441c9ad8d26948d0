#!/usr/bin/env python3
"""A timer at 2 Hz that says when a callback begins and when it ends; the node ends as the tutorial's does."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException


def timer_callback():
    print("begun")
    time.sleep(0.2)
    print("ended")


rclpy.init()
node = rclpy.create_node("signalled")
node.create_timer(0.5, timer_callback)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    rclpy.try_shutdown()
