"""The node of a test: it is connected to every topic of the other nodes as soon as they have it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from ..clocks.clock import nanoseconds
from ..messages.ros1 import TIMES, Message, SerializationError
from ..world import World
from . import client, rosgraph
from .exceptions import ROSSerializationException
from .msg import AnyMsg, args_kwds_to_message, serialize_message
from .state import State
from .topics import Publication

__all__ = ["Tester", "give_parameters"]

NAME = "/tester"


class Tester:
    """``world`` is its own; ``messages`` makes the classes of messages, as in ``messages["std_msgs/UInt32"]``."""

    def __init__(self, world: World, messages: Any) -> None:
        self._node = world.part(State)
        self._node.name = NAME
        self._messages = messages
        self._publications: dict[tuple[str, type[Message]], _Publication] = {}
        self._subscribed: dict[str, str] = {}  # the topics that somebody has published, and their types

    def publication(self, subscription: Any) -> Publication:
        """Its end for a subscription."""
        key = subscription.topic, subscription.data_class
        if key not in self._publications:
            self._publications[key] = _Publication(self._node, *key)
        return self._publications[key]

    def subscription(self, publication: Any) -> _Subscription:
        """Its end for a publication."""
        self._subscribed[publication.topic] = publication.type
        return _Subscription(self._node)

    def published(self, topic: str) -> str:
        """The full name of a topic that a node publishes, or has published. Raises LookupError if none does."""
        name = rosgraph.resolve_name(topic, NAME)
        if name not in self._subscribed:
            raise LookupError(f"no node publishes {name}; published are: {_list(self._subscribed.items())}")
        return name

    def message(self, type_: str, fields: dict[str, Any]) -> Message:
        """A message of a type such as std_msgs/UInt32. Raises LookupError if there is none, and what its class does."""
        try:
            data_class = self._messages[type_]
        except KeyError:
            where = "in the common packages, or in those around the node"
            raise LookupError(f"there is no message {type_} {where}") from None
        return data_class(**self._filled(data_class, fields))  # type: ignore[no-any-return]

    def publish(self, topic: str, args: tuple[Any, ...], fields: dict[str, Any]) -> None:
        """Put a message into the queues of the subscribers, as ``Publisher.publish`` does.

        Raises LookupError if there are none, and what ``Publisher.publish`` raises, but that breaks no connection.
        """
        name = rosgraph.resolve_name(topic, NAME)
        ends = [end for end in self._publications.values() if end.topic == name and end.connections]
        if not ends:
            subscribed = self._node.world.graph.subscribed()
            raise LookupError(f"no node subscribes to {name}; subscribed to are: {_list(subscribed)}")
        data_class = next((end.data_class for end in ends if end.data_class is not AnyMsg), None)
        if data_class:
            message = args_kwds_to_message(data_class, args, self._filled(data_class, fields))
        elif len(args) == 1 and hasattr(args[0], "_md5sum") and not fields:
            (message,) = args
        else:
            raise TypeError(f"{name} is subscribed to with rospy.AnyMsg, so publish a whole message there")
        for end in ends:
            if end.data_class is AnyMsg or end.data_class._md5sum == message._md5sum:
                end.send(message)

    def _filled(self, data_class: type[Message], fields: dict[str, Any]) -> dict[str, Any]:
        types = dict(zip(data_class.__slots__, data_class._slot_types, strict=True))
        return {name: self._value(types.get(name, ""), value) for name, value in fields.items()}

    def _value(self, type_: str, value: Any) -> Any:
        """A field's value; as for rostopic a dict stands for a message, and here a number of seconds for a time."""
        base, _, array = type_.partition("[")
        if array and ("/" in base or base in TIMES) and isinstance(value, (list, tuple)):
            return [self._value(base, item) for item in value]
        if base in TIMES and type(value) in (int, float):
            return TIMES[base]._of(nanoseconds(value))
        if isinstance(value, dict):
            return TIMES[base](**value) if base in TIMES else self.message(base, value)
        return value


def _list(topics: Iterable[tuple[str, str]]) -> str:
    return ", ".join(f"{topic} ({kind})" for topic, kind in topics) or "none"


class _Publication(Publication):
    delay = 0

    def send(self, message: Message) -> None:
        try:
            serialize_message(0, message)  # before it could break the connection
        except SerializationError as error:
            raise ROSSerializationException(str(error)) from None
        if self.data_class is AnyMsg:
            self.data_class, self.type = type(message), message._type
        self._send(message, self.connections)


class _Subscription:
    """A subscription with its only connection, which is there at once.

    So nothing that a node publishes is lost, and all of it is checked, as it is when somebody receives it.
    """

    data_class = AnyMsg
    broken = False

    def __init__(self, node: State) -> None:
        self.node = node
        self.subscription = self

    def connect(self, publication: Publication, delay: int) -> None:
        self._publication = publication
        publication.accept(self)  # type: ignore[arg-type]

    def deliver(self, data: bytes) -> None:
        pass  # the run has recorded it

    def hang_up(self) -> None:
        pass

    def close(self) -> None:
        self._publication.drop(self)  # type: ignore[arg-type]


def give_parameters(world: World, parameters: Mapping[str, Any]) -> None:
    """Set parameters of a node before it runs; the caller acts for it. Private ones, ``~rate``, are set with its name.

    Raises what ``set_param`` does.
    """
    private = world.part(State).private_parameters
    for name, value in parameters.items():
        if rosgraph.is_private(name):
            private[name[1:]] = value
        else:
            client.set_param(name, value)
