"""What tests of nodes look at, or replace, inside rclpy."""

import rclpy
from rclpy.executors import MultiThreadedExecutor, ShutdownException, SingleThreadedExecutor
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from rclpy.time_source import TimeSource
from scenario import say
from std_msgs.msg import Empty


class Heard:
    """Takes the place of the logger above all others."""

    def get_child(self, name):
        return self

    def warn(self, message, **options):
        say("heard", message)

    def info(self, message):
        say("heard", message)


rclpy.init()
node = rclpy.create_node("insides")
for kind in (SingleThreadedExecutor, MultiThreadedExecutor):
    executor = kind()
    calls = executor._wait_for_ready_callbacks()
    executor.shutdown()
    try:
        next(calls)
    except ShutdownException:
        say(kind.__name__, "was shut down")

source = TimeSource(node=node)
say(source._get_node() is node)
source.detach_node()
say(source._get_node())

before, rclpy.logging._root_logger = rclpy.logging._root_logger, Heard()
rclpy.logging.get_logger("any").info("told")
node.create_publisher(Empty, "topic", QoSProfile(depth=1))
lasting = QoSProfile(depth=1, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL)
node.create_subscription(Empty, "topic", print, lasting)
for _ in range(4):
    rclpy.spin_once(node, timeout_sec=0.3)
rclpy.logging._root_logger = before
rclpy.shutdown()
