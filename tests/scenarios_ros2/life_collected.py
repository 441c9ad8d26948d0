"""Nodes that refer to themselves, as one with an action server does, are there until garbage is collected."""

import gc

import rclpy
from rclpy.action import ActionServer
from rclpy.node import Node
from test_msgs.action import Fibonacci

rclpy.init()
watch = rclpy.create_node("watch")


def see(what):
    rclpy.spin_once(watch, timeout_sec=0.3)
    print(what, sorted(name for name in watch.get_node_names() if name != "watch"))


for name in ("first", "second", "third"):
    node = Node(name)
    server = ActionServer(node, Fibonacci, f"do_{name}", lambda handle: None)
    node.destroy_node()
    del server, node
    see(f"{name} dropped")
gc.collect()
see("collected")
rclpy.shutdown()
