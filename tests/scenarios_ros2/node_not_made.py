"""Nodes whose __init__ does not call Node's, or does it too late."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from scenario import say
from std_msgs.msg import String
from std_srvs.srv import Trigger


def attempt(what, call):
    try:
        call()
        say(what, "-> nothing raised")
    except Exception as error:
        say(what, "->", type(error).__name__, error)


class Bare(Node):
    def __init__(self):
        self.period = 0.5


class Early(Node):
    def __init__(self):
        self.create_timer(1, print)
        super().__init__("early")


class Given(Node):
    def __init__(self):
        self.executor = SingleThreadedExecutor()
        super().__init__("given")


rclpy.init()
bare = Bare()
attempt("timer", lambda: bare.create_timer(1, print))
attempt("publisher", lambda: bare.create_publisher(String, "a", 1))
attempt("subscription", lambda: bare.create_subscription(String, "a", print, 1))
attempt("client", lambda: bare.create_client(Trigger, "a"))
attempt("service", lambda: bare.create_service(Trigger, "a", print))
attempt("logger", bare.get_logger)
attempt("clock", bare.get_clock)
attempt("name", bare.get_name)
attempt("spin", lambda: rclpy.spin_once(bare, timeout_sec=0.1))
attempt("early", Early)
attempt("given", Given)
rclpy.shutdown()
