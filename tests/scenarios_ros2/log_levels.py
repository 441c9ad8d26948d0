"""Which lines come, by the level of the logger; each says what its logger is called."""

import rclpy
from rclpy.logging import LoggingSeverity, get_logger, get_logger_effective_level
from scenario import say

rclpy.init()
node = rclpy.create_node("log_levels", namespace="robot")
logger = node.get_logger()
for level in (None, LoggingSeverity.DEBUG, LoggingSeverity.ERROR, LoggingSeverity.UNSET):
    if level is not None:
        logger.set_level(level)
    say("effective", logger.get_effective_level(), get_logger_effective_level("robot.log_levels"))
    logger.debug("debug")
    logger.info("info")
    logger.warn("warn")
    logger.warning("warning")
    logger.error("error")
    logger.fatal("fatal")
    logger.get_child("child").info("child")
get_logger("free").info("free")
rclpy.shutdown()
