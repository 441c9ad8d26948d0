"""Who is in the graph after destroy_node() of a node with an action server, or with a lifecycle."""

import gc

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from test_msgs.action import Fibonacci

gc.disable()  # what is collected when depends on all else
rclpy.init()
watch = rclpy.create_node("watch")
client = ActionClient(watch, Fibonacci, "fib")


def see(what):
    rclpy.spin_once(watch, timeout_sec=0.3)
    print(what, sorted(n for n in watch.get_node_names() if n != "watch"), client.server_is_ready())


node = Node("acts")
server = ActionServer(node, Fibonacci, "fib", lambda h: None)
see("made")
node.destroy_node()
see("node destroyed, server kept")
del server
see("server dropped")
del node
see("node dropped")
node = Node("again")
server = ActionServer(node, Fibonacci, "fib", lambda h: None)
see("made")
server.destroy()
see("server destroyed")
node.destroy_node()
see("node destroyed")
gc.collect()
managed = LifecycleNode("managed")
managed.destroy_node()
see("lifecycle destroyed")
del managed
gc.collect()
see("lifecycle dropped")
