#!/usr/bin/env python3

import signal

import rclpy
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import Float64


class DriverPyNode(Node):
    def __init__(self):
        super().__init__("driver_py_node")
        self.publisher = self.create_publisher(Float64, "speed", 10)
        self.create_timer(0.5, lambda: self.publisher.publish(Float64(data=0.3)))


def main():
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    node = DriverPyNode()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        node.publisher.publish(Float64(data=0.0))
    finally:
        rclpy.shutdown()


if __name__ == "__main__":
    main()
