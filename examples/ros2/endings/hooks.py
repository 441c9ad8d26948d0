#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException

rclpy.init()
node = rclpy.create_node("hooks")
rclpy.get_default_context().on_shutdown(lambda: print("hook"))
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    print("no hook")
finally:
    rclpy.try_shutdown()
