"""Names that are for what executors wait for, and what nodes import of rclpy's C++ module."""

# ruff: noqa: F401
import rclpy
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.context import Context
from rclpy.impl.implementation_singleton import rclpy_implementation as implementation
from rclpy.qos import QoSProfile
from rclpy.waitable import NumberOfEntities, Waitable
from test_msgs.action import Fibonacci


def attempt(text):
    try:
        value = eval(text)
    except Exception as error:
        value = type(error).__name__, str(error).partition(" Error:")[0]
    print(text, "->", value)


attempt("NumberOfEntities(1, 2, 3) + NumberOfEntities(1, num_events=5)")
attempt("NumberOfEntities(1).num_subscriptions, NumberOfEntities().num_guard_conditions")
group = ReentrantCallbackGroup()
waitable = Waitable(group)
attempt("waitable.callback_group is group, group.has_entity(waitable)")
attempt("waitable.is_ready(None)")
attempt("waitable.take_data()")
attempt("waitable.get_num_entities()")
attempt("waitable.add_to_wait_set(None)")
attempt("waitable.__enter__(), waitable.__exit__(None, None, None)")
names = "InvalidHandle NodeNameNonExistentError RCLError RCLInvalidROSArgsError RMWError UnknownROSArgsError"
for name in (*names.split(), "UnsupportedEventTypeError"):
    kind = getattr(implementation, name)
    print(kind, [base.__name__ for base in kind.__mro__])
rclpy.init()
node = rclpy.create_node("node")
attempt("ActionClient(node, Fibonacci, 'count').get_num_entities()")
attempt("ActionServer(node, Fibonacci, 'count', print).get_num_entities()")
attempt("rclpy.create_node('another', cli_args=['--ros-args', '-r', 'no-rule'])")
attempt("rclpy.create_node('another', cli_args=['--ros-args', '--no-flag'])")
attempt("node.get_node_names_and_namespaces_with_enclaves()")
attempt("type(QoSProfile(depth=3).get_c_qos_profile()).__name__")
attempt("QoSProfile(**QoSProfile(depth=3).get_c_qos_profile().to_dict()) == QoSProfile(depth=3)")
attempt("QoSProfile(**implementation.rmw_qos_profile_t.predefined('qos_profile_sensor_data').to_dict()).depth")
attempt("implementation.rmw_qos_profile_t.predefined('qos_profile_none')")
attempt("rclpy.init(context=Context(), args=['no\\udcc3text'])")
timer = node.create_timer(1, print)
node.destroy_timer(timer)
try:
    timer.reset()
except InvalidHandle:
    print("gone")
rclpy.shutdown()
try:
    rclpy.shutdown()
except (RCLError, RuntimeError) as error:
    print(type(error))
