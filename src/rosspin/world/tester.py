"""The node that a test plays. It is connected to every topic of the other nodes as soon as they have it.

Every ROS has in common how topics and messages are named and filled in. Each has its own ends of topics.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from typing import Any

from .graph import Graph

__all__ = ["NAME", "Tester"]

NAME = "/tester"


class Tester(ABC):
    """``messages`` has the classes of messages by name, as in ``messages["std_msgs/UInt32"]``."""

    def __init__(self, graph: Graph, messages: Any) -> None:
        self._graph = graph
        self._messages = messages
        self._published: dict[str, str] = {}  # the topics that somebody has published, and their types

    @abstractmethod
    def publication(self, subscription: Any) -> Any:
        """Its end for a subscription."""

    def subscription(self, publication: Any) -> Any:
        """Its end for a publication."""
        self._published[publication.topic] = publication.type
        return self._listen(publication)

    @abstractmethod
    def _listen(self, publication: Any) -> Any: ...

    def published(self, topic: str) -> str:
        """The full name of a topic that a node publishes, or has published. Raises LookupError if none does."""
        name = _full_name(topic)
        if name not in self._published:
            raise LookupError(f"no node publishes {name}; published are: {_list(self._published.items())}")
        return name

    def message(self, type_: str, fields: Mapping[str, Any]) -> Any:
        """Make a message of a type such as std_msgs/UInt32. Raises LookupError if unknown, and as its class does."""
        try:
            data_class = self._messages[type_]
        except KeyError:
            where = "in the common packages, or in those around the node"
            raise LookupError(f"there is no message {type_} {where}") from None
        return data_class(**self._filled(data_class, fields))

    def publish(self, topic: str, args: tuple[Any, ...], fields: Mapping[str, Any]) -> None:
        """Put a message into the queues of the subscribers.

        Raises LookupError if there are none, and what this ROS raises for a message that cannot be published.
        """
        name = _full_name(topic)
        if not self._publish(name, args, fields):
            raise LookupError(f"no node subscribes to {name}; subscribed to are: {_list(self._graph.subscribed())}")

    @abstractmethod
    def _publish(self, name: str, args: tuple[Any, ...], fields: Mapping[str, Any]) -> bool:
        """Publish a message. Returns whether anybody subscribes."""

    def _filled(self, data_class: Any, fields: Mapping[str, Any]) -> dict[str, Any]:
        types = self._types(data_class)
        return {name: self._value(types.get(name, ""), value) for name, value in fields.items()}

    @staticmethod
    @abstractmethod
    def _types(data_class: Any) -> dict[str, str]:
        """The fields of a message and their types, as in ``std_msgs/Header`` and ``time[]``."""

    def _value(self, type_: str, value: Any) -> Any:
        """A field's value. As for rostopic, a dict stands for a message; here, a number of seconds also for a time."""
        base, _, array = type_.partition("[")
        if array and isinstance(value, (list, tuple)):
            return [self._value(base, item) for item in value]
        if type(value) in (int, float):
            return self._number(base, value)
        return self._nested(base, value) if isinstance(value, dict) else value

    @abstractmethod
    def _number(self, type_: str, value: float) -> Any:
        """The value of a field for which a number is given: a time, if the type is one."""

    def _nested(self, type_: str, fields: Mapping[str, Any]) -> Any:
        return self.message(type_, fields)


def _full_name(topic: str) -> str:
    return topic if topic.startswith("/") else f"/{topic}"


def _list(topics: Iterable[tuple[str, str]]) -> str:
    return ", ".join(f"{topic} ({kind})" for topic, kind in topics) or "none"
