#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import UInt32


class PubsubPyNode(Node):
    def __init__(self):
        super().__init__("pubsub_py_node")
        self.counter = 0
        self.publisher = self.create_publisher(UInt32, "counter", 10)
        self.create_subscription(
            UInt32, "counter", self.counter_callback, 10)
        timer_delta_t_in_seconds = 0.5
        self.create_timer(
            timer_delta_t_in_seconds, self.timer_callback)

    # Respond to the timer
    def timer_callback(self):
        self.counter += 1
        self.publisher.publish(UInt32(data=self.counter))

    # Respond to a message
    def counter_callback(self, message):
        self.get_logger().info(
            "[PUBSUB PY NODE] counter = " + str(message.data))


def main():
    rclpy.init()
    pubsub_py_node = PubsubPyNode()
    try:
        rclpy.spin(pubsub_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
