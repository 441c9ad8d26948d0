"""Nodes to which nothing refers any more: their names, publishers and timers, with __del__ and finalize."""

import gc
import weakref

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

rclpy.init()
watch = rclpy.create_node("watch")


def names():
    return sorted(watch.get_node_names())


def local():
    node = rclpy.create_node("short")
    node.create_publisher(String, "chatter", 10)
    node.create_timer(0.1, lambda: print("short ticks"))
    print("inside", names(), watch.count_publishers("chatter"))


local()
gc.collect()
rclpy.spin_once(watch, timeout_sec=0.5)
print("after", names(), watch.count_publishers("chatter"))


class Fails(Node):
    def __init__(self):
        super().__init__("fails")
        self.create_publisher(String, "chatter", 10)
        raise ValueError("no hardware")


for attempt in range(2):
    try:
        Fails()
    except ValueError as error:
        print(error)
    gc.collect()
rclpy.spin_once(watch, timeout_sec=0.5)
print("after", names(), watch.count_publishers("chatter"))

node = rclpy.create_node("replaced")
node = rclpy.create_node("replaced")
print("replaced", names())
gc.collect()
rclpy.spin_once(watch, timeout_sec=0.5)
print("replaced", names())

p = node.create_publisher(String, "kept", 10)
del p
gc.collect()
print("kept", watch.count_publishers("kept"))
s = watch.create_subscription(String, "kept", lambda m: print("got", m.data), 10)
s = None
gc.collect()
node.create_publisher(String, "kept", 10).publish(String(data="x"))
rclpy.spin_once(watch, timeout_sec=0.5)
print("kept", watch.count_subscribers("kept"), watch.count_publishers("kept"))


class Deletes(Node):
    def __del__(self):
        print("__del__", names())


weakref.finalize(Deletes("deletes"), print, "finalized")
print("kept by a publisher:")
pub = rclpy.create_node("kept").create_publisher(
    String, "latched", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
)
pub.publish(String(data="old"))
print(names(), watch.count_publishers("latched"))
late = watch.create_subscription(String, "latched", lambda m: print("late", m.data), pub.qos_profile)
rclpy.spin_once(watch, timeout_sec=0.5)
del pub
print(names(), watch.count_publishers("latched"))
