"""Logs only errors, by its command line."""

import rclpy
from scenario import say, wait_for_invitation

rclpy.init()
node = rclpy.create_node("quiet")
wait_for_invitation(node)
node.get_logger().info("not said")
node.get_logger().error("said all the same")
say(node.get_logger().get_effective_level())
rclpy.shutdown()
