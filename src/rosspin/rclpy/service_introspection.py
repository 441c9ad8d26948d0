"""How much of its calls a client or service publishes (sources: rclpy/service_introspection.py, rcl)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .clock import Clock
from .enumerations import PlainCppEnum
from .exceptions import not_accepted
from .qos import QoSProfile
from .topics import PublisherEndpoint

if TYPE_CHECKING:
    from ..messages.ros2 import Message
    from ..messages.ros2 import Service as Interface

__all__ = ["ServiceIntrospectionState"]


class ServiceIntrospectionState(PlainCppEnum):
    """Nothing, that a call was made or answered, or also what was said."""

    OFF = 0
    METADATA = 1
    CONTENTS = 2


class Events:
    """Publishes what a client or service does, on ``<service>/_service_event``."""

    def __init__(self, endpoint: Any, srv_type: type[Interface]) -> None:
        self._endpoint = endpoint
        self._type: Any = srv_type
        self._state = ServiceIntrospectionState.OFF
        self._publisher: PublisherEndpoint | None = None
        self._clock: Clock | None = None

    def configure(self, clock: Any, qos: Any, state: Any) -> None:
        """Begin, continue otherwise, or stop. Raises AttributeError and TypeError for what is none of these."""
        if not isinstance(clock, Clock):
            raise AttributeError(f"{type(clock).__name__!r} object has no attribute 'handle'")
        if not isinstance(qos, QoSProfile):
            raise AttributeError(f"{type(qos).__name__!r} object has no attribute 'get_c_qos_profile'")
        endpoint = self._endpoint
        if not isinstance(state, ServiceIntrospectionState):
            kind = "Client" if endpoint.asks else "Service"
            signature = (
                f"(self: rclpy._rclpy_pybind11.{kind}, arg0: rclpy::Clock, arg1: object, "
                "arg2: rclpy._rclpy_pybind11.service_introspection.ServiceIntrospectionState) -> None"
            )
            raise not_accepted(signature, kind, "Clock", "rmw_qos_profile_t", state, function="configure_introspection")
        self._clock, self._state = clock, state
        if state is ServiceIntrospectionState.OFF:
            self.stop()
        elif not self._publisher:
            topic = f"{endpoint.entry.topic}/_service_event"
            self._publisher = PublisherEndpoint(endpoint.node, self._type.Event, topic, qos).begin()

    def stop(self) -> None:
        """Publish no more."""
        if self._publisher:
            publisher, self._publisher = self._publisher, None
            publisher.destroy()

    def tell(self, number: int, gid: bytes, sequence: int, **contents: Message) -> None:
        """Publish an event by its number in ServiceEventInfo; ``request`` or ``response`` is what was said."""
        if self._publisher and self._clock:
            kind = import_module("service_msgs.msg").ServiceEventInfo
            info = kind(event_type=number, client_gid=list(gid), sequence_number=sequence)
            info.stamp = self._clock.now().to_msg()
            said = {name: [message] for name, message in contents.items()}
            said = said if self._state is ServiceIntrospectionState.CONTENTS else {}
            self._publisher.publish(self._type.Event(info=info, **said))
