#!/usr/bin/env python3
"""A Rate loop in a thread beside rclpy.spin; a pass may take its time.

Parameters: period, block (s), block_call (the pass that takes so long, 0: each).
"""

import time
from threading import Thread

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class RateProbe(Node):
    def __init__(self):
        super().__init__("rate_probe")
        self.block = self.declare_parameter("block", 0.0).value
        self.block_call = self.declare_parameter("block_call", 0).value
        period = self.declare_parameter("period", 0.5).value
        self.rate = self.create_rate(1.0 / period)
        Thread(target=self.loop, daemon=True).start()

    def loop(self):
        number = 0
        while rclpy.ok():
            number += 1
            if self.block_call in (0, number):
                time.sleep(self.block)
            self.rate.sleep()


def main():
    rclpy.init()
    node = RateProbe()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
