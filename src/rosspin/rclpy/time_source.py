"""Where ROS time comes from (source: rclpy/time_source.py)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .clock import ROSClock
from .parameter import Parameter
from .qos import QoSProfile, ReliabilityPolicy
from .time import ClockType, Time

if TYPE_CHECKING:
    from .node import Node
    from .topics import Subscription

__all__ = ["CLOCK_TOPIC", "USE_SIM_TIME_NAME", "TimeSource"]

CLOCK_TOPIC = "/clock"
USE_SIM_TIME_NAME = "use_sim_time"


class TimeSource:
    """Tells clocks the time of /clock while a node's ``use_sim_time`` is true; 0 until the first message comes."""

    def __init__(self, *, node: Node | None = None) -> None:
        self._node: Node | None = None
        self._subscription: Subscription | None = None
        self._clocks: list[ROSClock] = []
        self._told = Time(clock_type=ClockType.ROS_TIME)
        self._is_active = False
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clocks tell the time of /clock."""
        return self._is_active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if self._is_active == enabled:
            return
        self._is_active = enabled
        for clock in self._clocks:
            clock._set_ros_time_is_active(enabled)
        if not enabled:
            self._unsubscribe()
        elif self._node is not None:
            qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
            kind = import_module("rosgraph_msgs.msg").Clock
            self._subscription = self._node.create_subscription(kind, CLOCK_TOPIC, self.clock_callback, qos)

    def _unsubscribe(self) -> None:
        if self._node is not None and self._subscription is not None:
            self._node.destroy_subscription(self._subscription)
        self._subscription = None

    def attach_node(self, node: Node) -> None:
        """Follow the parameter ``use_sim_time`` of a node, and /clock by it."""
        self._unsubscribe()
        self._node = node
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        given = node.get_parameter(USE_SIM_TIME_NAME)
        if given.type_ is Parameter.Type.BOOL:
            self.ros_time_is_active = given.value
        else:
            node.get_logger().error(f"Invalid type for parameter 'use_sim_time' {given.type_!r} should be bool")
        node.add_on_set_parameters_callback(self._on_set)

    def detach_node(self) -> None:
        """Stop following the node."""
        self._unsubscribe()
        self._node = None

    def attach_clock(self, clock: ROSClock) -> None:
        """Tell a clock the time. Raises ValueError unless it is a ROSClock."""
        if not isinstance(clock, ROSClock):
            raise ValueError("Only clocks with type ROS_TIME can be attached.")
        clock.set_ros_time_override(self._told)
        clock._set_ros_time_is_active(self._is_active)
        self._clocks.append(clock)

    def clock_callback(self, msg: Any) -> None:
        """Take the time from a message, rosgraph_msgs/Clock."""
        self._told = Time.from_msg(msg.clock)
        for clock in self._clocks:
            clock.set_ros_time_override(self._told)

    def _on_set(self, parameters: list[Parameter]) -> Any:
        reason = ""
        for parameter in parameters:
            if parameter.name == USE_SIM_TIME_NAME:
                if parameter.type_ is Parameter.Type.BOOL:
                    self.ros_time_is_active = parameter.value
                else:
                    reason = "use_sim_time parameter set to something besides a bool"
                    if self._node is not None:
                        self._node.get_logger().error(reason)
        return import_module("rcl_interfaces.msg").SetParametersResult(successful=not reason, reason=reason)
