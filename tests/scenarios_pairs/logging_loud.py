"""The level of its logger is its own."""

import rclpy
from rclpy.logging import LoggingSeverity
from scenario import invite

rclpy.init()
node = rclpy.create_node("loud")
node.get_logger().set_level(LoggingSeverity.DEBUG)
invite(node)
node.get_logger().debug("a detail")
node.get_logger().info("said aloud")
rclpy.shutdown()
