"""The level of all loggers, or of one, from the command line."""

import rclpy
from rclpy.logging import get_logger
from scenario import say

rclpy.init()
node = rclpy.create_node("node")
for logger in (node.get_logger(), get_logger("free")):
    say(logger.name, logger.get_effective_level())
    logger.debug("debug")
    logger.info("info")
    logger.error("error")
