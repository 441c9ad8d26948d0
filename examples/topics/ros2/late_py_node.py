#!/usr/bin/env python3

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import UInt32


class LatePyNode(Node):
    def __init__(self):
        super().__init__("late_py_node")
        # Change RELIABLE to BEST_EFFORT, VOLATILE to TRANSIENT_LOCAL
        reliability = self.declare_parameter("reliability", "RELIABLE")
        durability = self.declare_parameter("durability", "VOLATILE")
        self.qos = QoSProfile(
            depth=3,
            reliability=ReliabilityPolicy[reliability.value],
            durability=DurabilityPolicy[durability.value])
        # Subscribe after so many seconds
        late = self.declare_parameter("late", 2.2)
        self.timer = self.create_timer(late.value, self.timer_callback)

    def timer_callback(self):
        self.timer.cancel()  # once is enough
        self.create_subscription(
            UInt32, "counter", self.counter_callback, self.qos)
        self.get_logger().info("[LATE PY NODE] subscribes")

    def counter_callback(self, message):
        self.get_logger().info(
            "[LATE PY NODE] counter = " + str(message.data))


def main():
    rclpy.init()
    late_py_node = LatePyNode()
    try:
        rclpy.spin(late_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
