"""What few nodes ask for: the folder of the logs, events of all parameters, a time source that lets go of its node."""

import os

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.logging import get_logging_directory
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.time_source import TimeSource
from rosgraph_msgs.msg import Clock
from scenario import say

os.environ["ROS_HOME"] = "/home/of/ros"
os.environ.pop("ROS_LOG_DIR", None)
say(get_logging_directory())
os.environ["ROS_LOG_DIR"] = "/elsewhere"
say(get_logging_directory())

rclpy.init()
node = rclpy.create_node("names_rarely_used")
target = rclpy.create_node("target")
executor = SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(target)


def on_event(event):
    say(event.node, [parameter.name for parameter in event.new_parameters])


client = AsyncParameterClient(node, "target")
subscription = client.on_parameter_event(on_event)
say(subscription.topic_name)
while node.count_publishers("/parameter_events") < 2:
    executor.spin_once(timeout_sec=0.1)
for _ in range(10):
    executor.spin_once(timeout_sec=0.05)
target.declare_parameter("rate", 10.0)
for _ in range(10):
    executor.spin_once(timeout_sec=0.05)


def heard():
    return [each.topic_name for each in follower.subscriptions if each.topic_name == "/clock"]


follower = rclpy.create_node("follower", parameter_overrides=[Parameter("use_sim_time", value=True)])
before = len(heard())
source = TimeSource(node=follower)
say(len(heard()) - before, source.ros_time_is_active)
source.detach_node()
say(len(heard()) - before, source.ros_time_is_active)
source.detach_node()
source.attach_clock(follower.get_clock())
source.clock_callback(Clock())
say(follower.get_clock().now().nanoseconds)
rclpy.shutdown()
