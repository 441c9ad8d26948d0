"""The topics on which every node publishes (sources: rclpy/node.py, rcl/logging_rosout.c).

Few nodes are listened to there: a publisher is made when someone subscribes to the topic or counts its publishers.
"""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable
from types import CodeType, ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

from .discovery import Participants
from .duration import Duration
from .parameter import Parameter
from .qos import DurabilityPolicy, QoSProfile, qos_profile_parameter_events
from .time import Time
from .topics import PublisherEndpoint

if TYPE_CHECKING:
    from .handle import RclNode
    from .topics import Publisher

__all__ = ["PARAMETER_EVENTS", "ROSOUT", "TYPES", "Code", "OwnTopics", "look"]

PARAMETER_EVENTS = "/parameter_events"
ROSOUT = "/rosout"

# The type of each, as the graph names it.
TYPES = {PARAMETER_EVENTS: {"rcl_interfaces/msg/ParameterEvent"}, ROSOUT: {"rcl_interfaces/msg/Log"}}

_QOS = {
    PARAMETER_EVENTS: qos_profile_parameter_events,
    ROSOUT: QoSProfile(depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)),
}


class Code(NamedTuple):
    """Where a message was logged, in a language that has no code objects."""

    co_filename: str
    co_name: str


class _Looked(set[str]):
    """The topics at which someone has looked in this run. Its processes share them."""


class OwnTopics:
    """A node's. ``types`` has their classes: the module ``rcl_interfaces.msg`` of the node's process."""

    def __init__(self, node: RclNode, types: ModuleType, on_rosout: bool) -> None:
        self._node = node
        self._types = types
        self._topics = [PARAMETER_EVENTS, ROSOUT] if on_rosout else [PARAMETER_EVENTS]
        self._rosout: PublisherEndpoint | None = None
        # What was logged before someone listens: when (ns), level, logger, text, line, code.
        self._early: deque[tuple[int, int, str, str, int, CodeType | Code]] = deque(maxlen=_QOS[ROSOUT].depth)

    def look(self) -> None:
        """Make the publishers of the topics at which someone has looked in this run."""
        for topic in self._node.context.state.world.graph.part(_Looked):
            self.make(topic)

    def make(self, topic: str) -> None:
        """Make the publisher of a topic, unless there is one. Others find it as if it had always been there."""
        node, made_by = self._node, self._node.node()
        if topic not in self._topics or node not in node.context.nodes or not node.context.ok():
            return
        if topic == PARAMETER_EVENTS and made_by is None:
            return
        self._topics.remove(topic)
        with node.context.state.world.acting():
            kind = self._types.Log if topic == ROSOUT else self._types.ParameterEvent
            endpoint = PublisherEndpoint(node, kind, topic, _QOS[topic])
            endpoint.made = node.context.born.get(node, endpoint.made)
            if topic == ROSOUT:
                endpoint.begin()
                node.release()  # rcl ends it with the node, at the latest
                endpoint.kept.extend((self._line(*logged), logged[0]) for logged in self._early)
                self._early.clear()
                self._rosout = endpoint
            elif made_by:
                made_by._rosspin_add_event_publisher(endpoint)

    def make_with(self, create: Callable[..., Any]) -> Any:
        """Let a method of the node's class make the publisher of /parameter_events."""
        self._topics.remove(PARAMETER_EVENTS)
        return create(self._types.ParameterEvent, PARAMETER_EVENTS, _QOS[PARAMETER_EVENTS])

    def end(self) -> None:
        """End what rcl ends with the node."""
        if self._rosout:
            self._rosout.destroy()

    def tell_parameters(
        self,
        publisher: Publisher,
        stamp: Time,
        node: str,
        new: list[Parameter],
        changed: list[Parameter],
        deleted: list[Parameter],
    ) -> None:
        """Publish what has been set in a node."""
        event = self._types.ParameterEvent(stamp=stamp.to_msg(), node=node)
        event.new_parameters = [each.to_parameter_msg() for each in new]
        event.changed_parameters = [each.to_parameter_msg() for each in changed]
        event.deleted_parameters = [each.to_parameter_msg() for each in deleted]
        publisher.publish(event)

    def tell_log(self, level: int, name: str, message: str, line: int, code: CodeType | Code) -> None:
        """Publish a message of the node's logger, or of one below it, and where it was logged."""
        if self._node.context.ok():
            now = self._node.context.state.clock.system()
            logged = now, level, name, message, line, code
            if self._rosout:
                self._rosout.publish(self._line(*logged))
            else:
                self._early.append(logged)

    def _line(self, when: int, level: int, name: str, text: str, number: int, code: CodeType | Code) -> Any:
        file, stamp = os.path.abspath(code.co_filename), Time(nanoseconds=when).to_msg()
        kind: Any = self._types.Log
        return kind(stamp=stamp, level=level, name=name, msg=text, file=file, function=code.co_name, line=number)


def look(node: RclNode, topic: str) -> None:
    """Let every node of the run, those to come as well, publish on one of these topics."""
    graph = node.context.state.world.graph
    looked = graph.part(_Looked)
    if topic in TYPES and topic not in looked:
        looked.add(topic)
        for each in graph.part(Participants).all_nodes():
            each.topics.make(topic)
