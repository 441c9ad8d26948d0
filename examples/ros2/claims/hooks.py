#!/usr/bin/env python3
"""A hook for the shutdown of ROS.

Parameter: shutdown (whether the node itself calls for it, after 1 s).
"""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class HooksClaim(Node):
    def __init__(self):
        super().__init__("hooks_claim")
        self.start = time.monotonic()
        self.context.on_shutdown(lambda: self.say("hook"))
        if self.declare_parameter("shutdown", False).value:
            self.create_timer(1.0, rclpy.shutdown)

    def say(self, what):
        now = time.monotonic() - self.start
        print(f"said,{now:.3f},{what}", flush=True)


def main():
    rclpy.init()
    node = HooksClaim()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
        node.say("end")


if __name__ == "__main__":
    main()
