"""After Ctrl-C each line that a node logs comes with one of rcl, until the shutdown."""

import rclpy
from scenario import P, begin


def log(logger):
    logger.info("after Ctrl-C")


rclpy.init()
node = rclpy.create_node("ctrl_c_log", namespace="/mrp")
quiet = rclpy.create_node("quiet", enable_rosout=False)
gone = rclpy.create_node("gone")
child = node.get_logger().get_child("child")
gone_logger = gone.get_logger()
gone.destroy_node()
begin()
node.create_timer(P, lambda: None)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
loggers = node.get_logger(), child, quiet.get_logger(), gone_logger, rclpy.logging.get_logger("free")
for logger in (*loggers, rclpy.logging.get_logger("mrp.ctrl_c_log.other")):
    log(logger)
rclpy.try_shutdown()
log(child)
node.destroy_node()
log(node.get_logger())
log(child)
