"""What rclpy's modules import themselves, and so pass on. Editors complete such imports, and many nodes have them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

__all__ = ["PASSED_ON", "passing_on"]

# By module, and by where each name comes from. Messages are each node's own, so they are looked up when asked for.
PASSED_ON: dict[str, dict[str, str]] = {
    "rclpy.action": {
        "action_msgs.msg": "GoalInfo GoalStatus",
        "action_msgs.srv": "CancelGoal",
        "unique_identifier_msgs.msg": "UUID",
    },
    "rclpy.executors": {
        ".clock": "Clock",
        ".exceptions": "InvalidHandle",
        ".services": "Client Service",
        ".time": "ClockType",
        ".timer": "Timer",
    },
    "rclpy.node": {
        "rcl_interfaces.msg": "FloatingPointRange IntegerRange ListParametersResult ParameterDescriptor ParameterEvent "
        "ParameterType ParameterValue SetParametersResult",
        ".exceptions": "InvalidParameterTypeException InvalidParameterValueException InvalidTopicNameException "
        "ParameterAlreadyDeclaredException ParameterImmutableException ParameterNotDeclaredException "
        "ParameterUninitializedException",
        ".executors": "Executor",
        ".logging": "get_logger",
        ".names": "expand_topic_name validate_full_topic_name validate_namespace validate_node_name "
        "validate_parameter_name validate_topic_name",
        ".parameter": "PARAMETER_SEPARATOR_STRING",
        ".qos": "qos_profile_parameter_events",
    },
    "rclpy.parameter": {"rcl_interfaces.msg": "ParameterType ParameterValue"},
    "rclpy.parameter_client": {
        "rcl_interfaces.msg": "ParameterEvent",
        "rcl_interfaces.srv": "DescribeParameters GetParameters GetParameterTypes ListParameters SetParameters "
        "SetParametersAtomically",
        ".node": "Node",
        ".task": "Future",
    },
    "rclpy.parameter_event_handler": {"rcl_interfaces.msg": "ParameterEvent", ".node": "Node"},
    "rclpy.time_source": {"rcl_interfaces.msg": "SetParametersResult"},
}


def passing_on(module: str, sources: Mapping[str, str]) -> Callable[[str], Any]:
    """Make the ``__getattr__`` for a module that passes on names of others."""
    homes = {name: source for source, names in sources.items() for name in names.split()}

    def find(name: str) -> Any:
        if name in homes:
            return getattr(import_module(homes[name], __package__), name)
        raise AttributeError(f"module {module!r} has no attribute {name!r}", name=name)

    return find
