"""Where ROS time comes from (source: rclpy/time_source.py)."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any
from weakref import ref

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


def _nobody() -> None:
    return None


class TimeSource:
    """Tells clocks the time of /clock while a node's ``use_sim_time`` is true; 0 until the first message comes."""

    def __init__(self, *, node: Node | None = None) -> None:
        self._node_weak_ref: Callable[[], Node | None] = _nobody
        self._clock_sub: Subscription | None = None
        self._associated_clocks: list[ROSClock] = []
        self._last_time_set = Time(clock_type=ClockType.ROS_TIME)
        self._ros_time_is_active = False
        if node is not None:
            self.attach_node(node)

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clocks tell the time of /clock."""
        return self._ros_time_is_active

    @ros_time_is_active.setter
    def ros_time_is_active(self, enabled: bool) -> None:
        if self._ros_time_is_active == enabled:
            return
        self._ros_time_is_active = enabled
        for clock in self._associated_clocks:
            clock._set_ros_time_is_active(enabled)
        if not enabled:
            self._rosspin_unsubscribe()
        elif (node := self._get_node()) is not None:
            qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
            kind = import_module("rosgraph_msgs.msg").Clock
            self._clock_sub = node.create_subscription(kind, CLOCK_TOPIC, self.clock_callback, qos)
            node._rosspin.context.state.world.await_spin(-1)  # the node itself does not wait for it

    def _rosspin_unsubscribe(self) -> None:
        node = self._get_node()
        if node is not None and self._clock_sub is not None:
            node.destroy_subscription(self._clock_sub)
        self._clock_sub = None

    def _get_node(self) -> Node | None:
        return self._node_weak_ref()

    def attach_node(self, node: Node) -> None:
        """Follow the parameter ``use_sim_time`` of a node, and /clock by it."""
        self._rosspin_unsubscribe()
        self._node_weak_ref = ref(node)
        if not node.has_parameter(USE_SIM_TIME_NAME):
            node.declare_parameter(USE_SIM_TIME_NAME, False)
        given = node.get_parameter(USE_SIM_TIME_NAME)
        if given.type_ is Parameter.Type.BOOL:
            self.ros_time_is_active = given.value
        else:
            node.get_logger().error(f"Invalid type for parameter 'use_sim_time' {given.type_!r} should be bool")
        node.add_on_set_parameters_callback(self._on_parameter_event)

    def detach_node(self) -> None:
        """Stop following the node."""
        self._rosspin_unsubscribe()
        self._node_weak_ref = _nobody

    def attach_clock(self, clock: ROSClock) -> None:
        """Tell a clock the time. Raises ValueError unless it is a ROSClock."""
        if not isinstance(clock, ROSClock):
            raise ValueError("Only clocks with type ROS_TIME can be attached.")
        clock.set_ros_time_override(self._last_time_set)
        clock._set_ros_time_is_active(self._ros_time_is_active)
        self._associated_clocks.append(clock)

    def clock_callback(self, msg: Any) -> None:
        """Take the time from a message, rosgraph_msgs/Clock."""
        self._last_time_set = Time.from_msg(msg.clock)
        for clock in self._associated_clocks:
            clock.set_ros_time_override(self._last_time_set)

    def _on_parameter_event(self, parameters: list[Parameter]) -> Any:
        reason = ""
        for parameter in parameters:
            if parameter.name == USE_SIM_TIME_NAME:
                if parameter.type_ is Parameter.Type.BOOL:
                    self.ros_time_is_active = parameter.value
                else:
                    reason = "use_sim_time parameter set to something besides a bool"
                    if (node := self._get_node()) is not None:
                        node.get_logger().error(reason)
        return import_module("rcl_interfaces.msg").SetParametersResult(successful=not reason, reason=reason)
