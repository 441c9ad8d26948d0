"""What of a node can be copied deeply; and a list of numbers that no message holds is not declared."""

import copy
import pickle

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.parameter import Parameter
from scenario import say

rclpy.init()
node = rclpy.create_node("copies_of_parts")


def attempt(what, function):
    try:
        say(what, "->", function())
    except (OverflowError, TypeError) as error:
        say(what, "->", type(error).__name__, error)


logger = node.get_logger().get_child("part")
attempt("copied", lambda: copy.deepcopy({"log": logger})["log"].name)
attempt("pickled", lambda: pickle.loads(pickle.dumps(logger)).info("from the copy"))
for kind in (MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup):
    attempt(kind.__name__, lambda: type(copy.deepcopy(kind())).__name__)
    attempt(kind.__name__, lambda: type(copy.copy(kind())).__name__)
node.declare_parameter("numbers", [1])
attempt("set", lambda: node.set_parameters([Parameter("numbers", value=[2**63])]))
attempt("declare", lambda: node.declare_parameter("others", [2**63]))
say(node.get_parameter("numbers").value, node.has_parameter("others"))
rclpy.shutdown()
