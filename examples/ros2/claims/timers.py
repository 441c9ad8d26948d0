#!/usr/bin/env python3
"""Timers as nobody expects them.

Parameters: kind (one_shot, unspun, period), period (s, of the last kind).
"""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class TimersClaim(Node):
    def __init__(self):
        super().__init__("timers_claim")
        self.start = time.monotonic()
        self.calls = 0
        self.kind = self.declare_parameter("kind", "one_shot").value
        period = self.declare_parameter("period", 0.5).value
        try:
            self.timer = self.create_timer(period, self.timer_callback)
        except Exception as error:
            reason = str(error).partition(", at ")[0]
            self.say(f"{type(error).__name__}: {reason}")

    def timer_callback(self):
        self.calls += 1
        if self.kind == "one_shot":
            self.timer.cancel()

    def say(self, what):
        now = time.monotonic() - self.start
        print(f"said,{now:.3f},{what}", flush=True)


def main():
    rclpy.init()
    node = TimersClaim()
    try:
        if node.kind == "unspun":
            time.sleep(10)
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.say(f"calls: {node.calls}")
        if node.get_clock().ros_time_is_active:
            node.say(f"time: {node.get_clock().now().nanoseconds} ns")
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
