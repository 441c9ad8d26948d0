#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import UInt32


class EagerPyNode(Node):
    def __init__(self):
        super().__init__("eager_py_node")
        # Change RELIABLE to BEST_EFFORT, VOLATILE to TRANSIENT_LOCAL
        reliability = self.declare_parameter("reliability", "RELIABLE")
        durability = self.declare_parameter("durability", "VOLATILE")
        qos = QoSProfile(
            depth=3,
            reliability=ReliabilityPolicy[reliability.value],
            durability=DurabilityPolicy[durability.value])
        self.counter = 0
        self.publisher = self.create_publisher(UInt32, "counter", qos)
        # Publish immediately, and then every 0.5 s
        self.timer_callback()
        self.create_timer(0.5, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.publisher.publish(UInt32(data=self.counter))


def main():
    rclpy.init()
    eager_py_node = EagerPyNode()
    try:
        rclpy.spin(eager_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
