#!/usr/bin/env python3

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


# The light barrier sees a part
def read_barrier():
    return 1


class PartsPyNode(Node):
    def __init__(self):
        super().__init__("parts_py_node")
        self.parts = 0
        # Callbacks of this group may run at the same time
        group = ReentrantCallbackGroup()
        self.create_timer(0.1, self.left_callback, group)
        self.create_timer(0.1, self.right_callback, group)
        self.create_timer(1.05, self.report_callback, group)

    # A part passes on the left belt
    def left_callback(self):
        self.parts += read_barrier()

    # A part passes on the right belt
    def right_callback(self):
        self.parts += read_barrier()

    def report_callback(self):
        self.get_logger().info(f"[PARTS] parts = {self.parts}")


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(PartsPyNode())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
