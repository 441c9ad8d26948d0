#!/usr/bin/env python3
"""One or two timers under an executor of your choice; one's callback may take its time.

Parameters: period, block (s), block_call (the call that takes so long, 0: each), wait (s, before the spin),
second_timer, executor (spin, spin_once, multi), threads, group (default, own, reentrant).
"""

import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class TimerProbe(Node):
    def __init__(self):
        super().__init__("timer_probe")
        self.calls = 0
        self.block = self.declare_parameter("block", 0.0).value
        self.block_call = self.declare_parameter("block_call", 0).value
        period = self.declare_parameter("period", 0.5).value
        first, second = self.groups(
            self.declare_parameter("group", "default").value)

        self.create_timer(period, self.timer_callback, first)
        if self.declare_parameter("second_timer", False).value:
            self.create_timer(period, self.second_callback, second)

    def groups(self, kind):
        if kind == "own":
            return (MutuallyExclusiveCallbackGroup(),
                    MutuallyExclusiveCallbackGroup())
        if kind == "reentrant":
            return (ReentrantCallbackGroup(),) * 2
        return None, None

    def timer_callback(self):
        self.calls += 1
        if self.block_call in (0, self.calls):
            time.sleep(self.block)

    def second_callback(self):
        pass


def main():
    rclpy.init()
    node = TimerProbe()
    executor = node.declare_parameter("executor", "spin").value
    threads = node.declare_parameter("threads", 4).value
    time.sleep(node.declare_parameter("wait", 0.0).value)
    try:
        if executor == "multi":
            rclpy.spin(node, MultiThreadedExecutor(threads))
        elif executor == "spin_once":
            while rclpy.ok():
                # What is left of a second: another timeout each time
                rclpy.spin_once(node, timeout_sec=1 - time.time() % 1)
        else:
            rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
