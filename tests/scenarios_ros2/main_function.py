"""The form that a package's entry point has: main(args=None), called with the process's arguments."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from scenario import P, begin, mark, say


class MinimalNode(Node):
    def __init__(self):
        super().__init__("minimal_node")
        self.get_logger().info("made")
        begin()
        self.timer = self.create_timer(P, self.timer_callback)
        self.counter = 0

    def timer_callback(self):
        self.counter += 1
        mark("tick")
        self.get_logger().info(f"counter = {self.counter}")
        if self.counter == 3:
            raise SystemExit


def main(args=None):
    rclpy.init(args=args)
    node = MinimalNode()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        say("finally")
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())
