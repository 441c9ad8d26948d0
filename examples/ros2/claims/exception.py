#!/usr/bin/env python3
"""A timer whose callback takes 0.1 s and raises, beside one that goes on.

Parameter: threads (of the executor).
"""

import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


class ExceptionClaim(Node):
    def __init__(self):
        super().__init__("exception_claim")
        self.start = time.monotonic()
        self.threads = self.declare_parameter("threads", 1).value
        group = ReentrantCallbackGroup()
        self.create_timer(1.2, self.timer_callback, group)
        self.create_timer(0.5, lambda: self.say("other timer"), group)

    def timer_callback(self):
        time.sleep(0.1)
        self.say("callback raises")
        raise ValueError("in a callback")

    def say(self, what):
        now = time.monotonic() - self.start
        print(f"said,{now:.3f},{what}", flush=True)


def main():
    rclpy.init()
    node = ExceptionClaim()
    try:
        if node.threads > 1:
            rclpy.spin(node, MultiThreadedExecutor(node.threads))
        else:
            rclpy.spin(node, SingleThreadedExecutor())
    finally:
        node.say("spin raises")


if __name__ == "__main__":
    main()
