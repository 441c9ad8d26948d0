#!/usr/bin/env python3
"""A Rate loop that sleeps in main, where nobody spins, or in a callback.

Parameters: where (main, callback), threads (of the executor).
"""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.executors import MultiThreadedExecutor
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class RateClaim(Node):
    def __init__(self):
        super().__init__("rate_claim")
        self.start = time.monotonic()
        self.where = self.declare_parameter("where", "main").value
        self.threads = self.declare_parameter("threads", 1).value
        self.rate = self.create_rate(2.0)
        if self.where == "callback":
            self.timer = self.create_timer(0.75, self.timer_callback)

    def timer_callback(self):
        self.timer.cancel()
        self.loop()

    def loop(self):
        for number in range(1, 4):
            self.say(f"sleep {number} begins")
            self.rate.sleep()
            self.say(f"sleep {number} ends")

    def say(self, what):
        now = time.monotonic() - self.start
        print(f"said,{now:.3f},{what}", flush=True)


def main():
    rclpy.init()
    node = RateClaim()
    try:
        if node.where == "main":
            node.loop()
        elif node.threads > 1:
            rclpy.spin(node, MultiThreadedExecutor(node.threads))
        else:
            rclpy.spin(node, SingleThreadedExecutor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
