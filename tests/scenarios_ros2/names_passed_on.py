"""Names that nodes import from a module of rclpy which only imports them itself."""

import rclpy.node
from rclpy.action.client import CancelGoal, GoalStatus
from rclpy.action.server import GoalInfo
from rclpy.action.server import GoalStatus as GoalStatusOfServer
from rclpy.executors import Client, Clock, ClockType, Service, Timer
from rclpy.node import (
    PARAMETER_SEPARATOR_STRING,
    Executor,
    FloatingPointRange,
    IntegerRange,
    ParameterAlreadyDeclaredException,
    ParameterDescriptor,
    ParameterNotDeclaredException,
    ParameterType,
    SetParametersResult,
    expand_topic_name,
    get_logger,
    qos_profile_parameter_events,
    validate_topic_name,
)
from rclpy.parameter import ParameterType as ParameterTypeOfParameter
from rclpy.parameter import ParameterValue
from rclpy.parameter_event_handler import Node, ParameterEvent
from scenario import say

for kind in (
    *(CancelGoal, GoalStatus, GoalInfo, FloatingPointRange, IntegerRange, ParameterDescriptor, ParameterType),
    *(SetParametersResult, ParameterValue, ParameterEvent, Client, Clock, ClockType, Service, Timer, Executor, Node),
    *(ParameterAlreadyDeclaredException, ParameterNotDeclaredException),
):
    say(kind.__module__, kind.__name__)
say(GoalStatus is GoalStatusOfServer, GoalStatus.STATUS_SUCCEEDED, ParameterType is ParameterTypeOfParameter)
say(PARAMETER_SEPARATOR_STRING, expand_topic_name("old", "node", "/mrp"), validate_topic_name("/chatter"))
say(get_logger("some").name, qos_profile_parameter_events.depth)
say(hasattr(rclpy.node, "NoSuchName"))
