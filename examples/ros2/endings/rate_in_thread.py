#!/usr/bin/env python3

from threading import Thread

import rclpy
from rclpy.executors import ExternalShutdownException


def loop(rate):
    while rclpy.ok():
        rate.sleep()


rclpy.init()
node = rclpy.create_node("rate_in_thread")
Thread(target=loop, args=(node.create_rate(2.0),), daemon=True).start()
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    rclpy.try_shutdown()
