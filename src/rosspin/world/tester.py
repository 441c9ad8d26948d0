"""The node that a test plays. It is connected to every topic of the other nodes as soon as they have it.

Every ROS has in common how topics and messages are named and filled in. Each has its own endpoints of topics and
services.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from types import NoneType
from typing import Any

from ..clocks.simulation import Simulation
from .world import World

__all__ = ["NAME", "Tester"]

NAME = "/tester"

_WHERE = "in the common packages, or in those around the node"


Handler = Callable[[Any], Mapping[str, Any] | None]
"""Is given a request, and returns the fields of the response."""

Then = Callable[[Any], None]
"""Is given a response."""


class Tester(ABC):
    """A node that a test plays: it has an endpoint of its own for each one that the others have.

    ``messages`` has the classes by name, as in ``messages["std_msgs/UInt32"]``; ``fail`` ends the run."""

    def __init__(self, world: World, messages: Any, fail: Callable[[Exception], None]) -> None:
        self._world = world
        self._graph = world.graph
        self._messages = messages
        self._fail = fail
        self._published: dict[str, str] = {}  # the topics that someone has published, and their types

    @abstractmethod
    def publication(self, subscription: Any) -> Any:
        """Return its endpoint for a subscription."""

    def subscription(self, publication: Any) -> Any:
        """Return its endpoint for a publication."""
        self._published[publication.topic] = publication.type
        return self._listen(publication)

    @abstractmethod
    def _listen(self, publication: Any) -> Any: ...

    def published(self, topic: str) -> str:
        """Return the full name of a topic that a node publishes, or has published. Raises LookupError if none does."""
        name = _full_name(topic)
        if name not in self._published:
            raise LookupError(f"no node publishes {name}; published are: {_list(self._published.items())}")
        return name

    def message(self, type_: str, fields: Mapping[str, Any]) -> Any:
        """Make a message of a type such as std_msgs/UInt32. Raises LookupError if unknown, and as its class does."""
        try:
            data_class = self._messages[type_]
        except KeyError:
            raise LookupError(f"there is no message {type_} {_WHERE}") from None
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
        """Publish a message. Returns whether anyone subscribes."""

    def call(self, service: str, args: tuple[Any, ...], fields: Mapping[str, Any], then: Then | None = None) -> None:
        """Ask a service as soon as the time passes, and call ``then`` with the response.

        Raises LookupError if no node offers it, and what this ROS raises for a request that cannot be sent.
        """
        name = _full_name(service)
        offered = self._offered(name)
        if name not in offered:
            raise LookupError(f"no node offers {name}; offered are: {_list(offered.items())}")
        clock = self._world.clock
        assert isinstance(clock, Simulation)
        clock.soon(self._request(name, args, fields, then))

    @abstractmethod
    def _offered(self, name: str) -> dict[str, str]:
        """Return the services of the other nodes, and their types, for whoever looks for one by its name."""

    @abstractmethod
    def _request(
        self, name: str, args: tuple[Any, ...], fields: Mapping[str, Any], then: Then | None
    ) -> Callable[[], None]:
        """Make a request, and return what sends it."""

    @abstractmethod
    def send_goal(self, action: str, fields: Mapping[str, Any]) -> None:
        """Send a goal as soon as the time passes, and ask for its result later. Raises what ``call`` raises."""

    def serve(self, service: str, type_: str, handler: Handler) -> None:
        """Offer a service of a type such as std_srvs/SetBool. Raises LookupError if unknown."""
        try:
            srv_type = self._messages.whole("srv", type_)
        except KeyError:
            raise LookupError(f"there is no service {type_} {_WHERE}") from None
        self._serve(_full_name(service), srv_type, handler)

    @abstractmethod
    def _serve(self, name: str, srv_type: Any, handler: Handler) -> None: ...

    def _response(self, response_class: Any, handler: Handler, request: Any) -> Any:
        """Return the response to a request, or None. An error ends the run."""
        try:
            fields = handler(request)
            if not isinstance(fields, (Mapping, NoneType)):
                raise TypeError(f"the function of a service returns a dict of the response's fields, not {fields!r}")
            return None if fields is None else response_class(**self._filled(response_class, fields))
        except Exception as error:
            self._fail(error)

    def _filled(self, data_class: Any, fields: Mapping[str, Any]) -> dict[str, Any]:
        types = self._types(data_class)
        return {name: self._value(types.get(name, ""), value) for name, value in fields.items()}

    @staticmethod
    @abstractmethod
    def _types(data_class: Any) -> dict[str, str]:
        """Return the fields of a message and their types, as in ``std_msgs/Header`` and ``time[]``."""

    def _value(self, type_: str, value: Any) -> Any:
        """Make a field's value. A dict stands for a message, as for rostopic, and a number of seconds for a time."""
        base, _, array = type_.partition("[")
        if array and isinstance(value, (list, tuple)):
            return [self._value(base, item) for item in value]
        if type(value) in (int, float):
            return self._number(base, value)
        return self._nested(base, value) if isinstance(value, dict) else value

    @abstractmethod
    def _number(self, type_: str, value: float) -> Any:
        """Return the value of a field for which a number is given: a time, if the type is one."""

    def _nested(self, type_: str, fields: Mapping[str, Any]) -> Any:
        return self.message(type_, fields)


def _full_name(topic: str) -> str:
    return topic if topic.startswith("/") else f"/{topic}"


def _list(names: Iterable[tuple[str, str]]) -> str:
    return ", ".join(f"{name} ({kind})" for name, kind in names) or "none"
