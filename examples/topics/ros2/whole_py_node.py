#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float64


class WholePyNode(Node):
    def __init__(self):
        super().__init__("whole_py_node")
        self.publisher = self.create_publisher(Float64, "speed", 10)
        self.create_subscription(
            Float64, "speed", self.speed_callback, 10)
        self.create_timer(0.5, self.timer_callback)

    # Publish a whole number, where a float belongs
    def timer_callback(self):
        self.publisher.publish(Float64(data=1))

    def speed_callback(self, message):
        self.get_logger().info("[WHOLE PY NODE] speed = " + str(message.data))


def main():
    rclpy.init()
    whole_py_node = WholePyNode()
    try:
        rclpy.spin(whole_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
