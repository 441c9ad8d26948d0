"""Which modules of rclpy an import brings: ``import rclpy`` alone brings few, and all others are no names of it."""

from __future__ import annotations

from functools import cache

__all__ = ["brought_by"]

# By module, those that it imports when it is imported; those that these or ``rclpy`` bring anyway are left out.
_IMPORTS = {
    "": "_rclpy_pybind11 impl.implementation_singleton parameter signals task",
    "action": "action.client action.graph action.server",
    "action.client": "executors type_support",
    "action.graph": "node",
    "action.server": "executors type_support",
    "client": "callback_groups clock qos service_introspection",
    "clock": "time",
    "context": "destroyable",
    "event_handler": "callback_groups logging qos waitable",
    "executors": "client service subscription timer",
    "experimental": "experimental.events_executor",
    "experimental.events_executor": "executors",
    "guard_condition": "utilities",
    "impl.rcutils_logger": "clock impl.logging_severity",
    "lifecycle": "lifecycle.node",
    "lifecycle.node": "lifecycle.publisher node",
    "lifecycle.publisher": "lifecycle.managed_entity publisher",
    "logging": "impl.rcutils_logger",
    "logging_service": "impl.logging_severity qos validate_topic_name",
    "node": "executors expand_topic_name logging_service parameter_service qos_overriding_options time_source "
    "topic_endpoint_info type_description_service validate_full_topic_name validate_namespace "
    "validate_node_name validate_parameter_name",
    "parameter_client": "node",
    "parameter_event_handler": "node",
    "parameter_service": "qos validate_topic_name",
    "publisher": "event_handler",
    "qos": "duration",
    "qos_event": "event_handler",
    "qos_overriding_options": "publisher subscription",
    "serialization": "type_support",
    "service": "callback_groups clock qos service_introspection",
    "signals": "exceptions guard_condition",
    "subscription": "event_handler",
    "time": "clock_type duration",
    "time_source": "clock qos",
    "timer": "callback_groups clock",
    "topic_endpoint_info": "qos type_hash",
    "type_description_service": "service type_support validate_topic_name",
    "utilities": "constants context",
    "wait_for_message": "node",
}


# Likewise of packages next to rclpy (sources: tf2_ros_py/tf2_ros/buffer_client.py, message_filters/__init__.py).
_IMPORTS_BESIDE = {"message_filters": "node", "tf2_geometry_msgs": "action", "tf2_ros": "action"}


@cache
def brought_by(name: str) -> tuple[str, ...]:
    """Return the full names of rclpy's modules that importing a module brings, with parents before children."""
    package, _, module = name.partition(".")
    left = ["", module] if package == "rclpy" else _IMPORTS_BESIDE.get(package, "").split()
    found: set[str] = set()
    while left:
        each = left.pop()
        if each not in found:
            found.add(each)
            left += [each.rpartition(".")[0], *_IMPORTS.get(each, "").split()]
    return tuple(sorted(f"rclpy.{each}".rstrip(".") for each in found))
