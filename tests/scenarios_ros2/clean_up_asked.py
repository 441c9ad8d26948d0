"""What executors, actions and contexts say to bad arguments, after destroy_node(), and after shutdown."""

import gc
import warnings

import rclpy
from rclpy.action import ActionClient
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.qos import QoSProfile
from rclpy.wait_for_message import wait_for_message
from scenario import say
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci


def attempt(what, call):
    try:
        say(what, "->", call())
    except Exception as error:
        say(what, "->", type(error).__name__, str(error).partition(", at /")[0])


rclpy.init()
node = rclpy.create_node("asked")
attempt("-1 threads", lambda: MultiThreadedExecutor(num_threads=-1))
attempt("0 threads", lambda: MultiThreadedExecutor(0))
attempt("executor None", lambda: SingleThreadedExecutor().add_node(None))
attempt("type", lambda: node.create_client(String(), "a"))
node.create_publisher(String, "used", 1)
attempt("type", lambda: node.create_publisher(Trigger.Request, "used", 1))
attempt("slots", lambda: setattr(QoSProfile(depth=1), "name", "mine"))
with warnings.catch_warnings(record=True) as warned:
    warnings.simplefilter("default")
    for call in (lambda: QoSProfile(depth=0), lambda: node.create_publisher(String, "a", 0)):
        call()
say(len(warned), "warning")
acts = rclpy.create_node("acts")
client = ActionClient(acts, Fibonacci, "fib")
acts.destroy_node()
attempt("ready", client.server_is_ready)
attempt("wait", lambda: client.wait_for_server(timeout_sec=0.1))
attempt("destroy", client.destroy)
executor = SingleThreadedExecutor()
executor.add_node(node)
rclpy.shutdown()
attempt("spin_once", lambda: executor.spin_once(timeout_sec=0.1))
attempt("publishers", lambda: node.get_publishers_info_by_topic("a"))
attempt("subscriptions", lambda: node.get_subscriptions_info_by_topic("a"))
attempt("message", lambda: wait_for_message(String, node, "a", time_to_wait=0.1))
attempt("domain", node.context.get_domain_id)
gc.collect()
