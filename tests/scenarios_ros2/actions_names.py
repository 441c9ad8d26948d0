"""What an action is made of, and under which names."""

import warnings

import rclpy
from rclpy.action import ActionClient, ActionServer, get_action_names_and_types
from rclpy.action import get_action_client_names_and_types_by_node as clients
from rclpy.action import get_action_server_names_and_types_by_node as servers
from scenario import attempt, say
from test_msgs.action import Fibonacci

warnings.simplefilter("ignore")  # of what rcl cannot take away after a wrong name
rclpy.init()
node = rclpy.create_node("actions_names", namespace="/mrp")
server = ActionServer(node, Fibonacci, "fibonacci", lambda goal_handle: Fibonacci.Result())
client = ActionClient(node, Fibonacci, "~/other")
say(get_action_names_and_types(node))
say(servers(node, "actions_names", "/mrp"), clients(node, "actions_names", "/mrp"))
for name, types in node.get_topic_names_and_types(no_demangle=False):
    if "action" in name:
        say(name, *types)
for name, types in node.get_service_names_and_types():
    if "_action/" in name:
        say(name, *types)
say(client.server_is_ready())
for name in ("a b", "/", "2", "a//b", "~a"):
    attempt("ActionClient(node, Fibonacci, name)", {**globals(), "name": name})
