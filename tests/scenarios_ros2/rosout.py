"""What a node and those below its logger log is heard on /rosout; what it logged before has been kept for a while."""

import rclpy
from rcl_interfaces.msg import Log
from rclpy.qos import DurabilityPolicy, QoSProfile
from scenario import say


def hear(message):
    if message.name.startswith("rosout"):
        say(message.level, message.name, message.msg, message.file.rpartition("/")[2], message.function, message.line)
        heard.append(message)


def log(logger, text):
    logger.info(text)
    count = len(heard)
    for _ in range(3):
        if len(heard) == count:
            rclpy.spin_once(node, timeout_sec=0.2)


heard = []
rclpy.init()
node = rclpy.create_node("rosout")
subscription = node.create_subscription(Log, "/rosout", hear, 10)
log(node.get_logger(), "of the node")
child = node.get_logger().get_child("child")
log(child, "of a child")
log(child.get_child("grandchild"), "of a grandchild")
log(rclpy.logging.get_logger("rosout.other"), "of another one")
log(rclpy.logging.get_logger("another"), "of a stranger")
node.get_logger().debug("below the level")
quiet = rclpy.create_node("rosout_quiet", enable_rosout=False)
log(quiet.get_logger(), "of a node that does not publish")
node.get_logger().set_level(rclpy.logging.LoggingSeverity.DEBUG)
node.get_logger().debug("a debug message")
node.get_logger().fatal("a fatal one")
for _ in range(4):
    rclpy.spin_once(node, timeout_sec=0.2)
say(len(heard), node.count_publishers("/rosout"))
say([info[0] for info in node.get_topic_names_and_types() if info[0] == "/rosout"])
say([publisher.topic_name for publisher in node.publishers])
late = rclpy.create_node("rosout_late")
kept = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
late.create_subscription(Log, "/rosout", lambda message: say("late", message.msg), kept)
for _ in range(12):
    rclpy.spin_once(late, timeout_sec=0.2)
rclpy.shutdown()
