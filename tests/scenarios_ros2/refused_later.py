"""What is refused only by the C part, what cannot be set, and what a node waits for."""

import warnings

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from scenario import say
from std_msgs.msg import String
from test_msgs.action import Fibonacci


def attempt(what, call):
    try:
        say(what, "->", call())
    except Exception as error:
        say(what, "->", type(error).__name__, str(error).partition("\nInvoked")[0].partition(", at /")[0])


warnings.simplefilter("ignore", RuntimeWarning)  # of what the C part could not undo
rclpy.init()
for name, namespace in ((None, "/"), (b"bytes", b"of"), (3, "/"), ("n", 3), ("n", "n" * 300)):
    attempt("node", lambda: Node(name, namespace=namespace).get_fully_qualified_name())

node = Node("waits")
node.create_publisher(String, "published", 1)
node.create_subscription(String, "heard", print, 1)
say([publisher.topic for publisher in node.publishers])
say([handler.event_type.name for handler in node.waitables])
for name in ("two words", "2", "ends/"):
    attempt(name, lambda: ActionServer(node, Fibonacci, name, print))
    attempt(name, lambda: ActionClient(node, Fibonacci, name))

publisher = node.create_publisher(String, "marked", 1)
publisher.event_handlers = 7
node.create_subscription(String, "marked", print, 1)
say(publisher.event_handlers)
for value in (Duration(seconds=1), Time(seconds=1)):
    attempt("set", lambda: setattr(value, "nanoseconds", 1))
attempt("set", lambda: setattr(Time(), "clock_type", 1))
rclpy.shutdown()
