#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class ThirtyPyNode(Node):
    def __init__(self):
        super().__init__("thirty_py_node")
        self.counter = 0
        self.publisher = self.create_publisher(UInt32, "counter", 10)
        self.timer = self.create_timer(0.1, self.timer_callback)

    # Publish 0, 1, 2 up to 29, one every 0.1 s
    def timer_callback(self):
        if self.publisher.get_subscription_count() == 0:
            return  # nobody listens yet
        self.publisher.publish(UInt32(data=self.counter))
        self.counter += 1
        if self.counter == 30:
            self.timer.cancel()


def main():
    rclpy.init()
    thirty_py_node = ThirtyPyNode()
    try:
        rclpy.spin(thirty_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
