"""The node of a test: it is connected to every topic of the other nodes as soon as they have it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import partial
from typing import Any

from ..clocks.clock import nanoseconds
from ..messages.ros1 import TIMES, Message, SerializationError
from ..world import tester
from ..world.world import World
from . import client, rosgraph
from .exceptions import ROSSerializationException, TransportInitError
from .msg import AnyMsg, args_kwds_to_message, serialize_message
from .service import Connection, Service, Services
from .state import State
from .topics import Publication

__all__ = ["Tester", "give_parameters"]


class Tester(tester.Tester):
    """A tester on ROS 1 in its own ``world``; ``messages`` makes classes, as in ``messages["std_msgs/UInt32"]``."""

    def __init__(self, world: World, messages: Any, fail: Callable[[Exception], None]) -> None:
        super().__init__(world, messages, fail)
        self._node = world.part(State)
        self._node.name = tester.NAME
        self._node.initialized = True
        self._publications: dict[tuple[str, type[Message]], _Publication] = {}

    def publication(self, subscription: Any) -> Publication:
        """Return the tester's endpoint for a subscription."""
        kind = subscription.data_class
        if issubclass(kind, AnyMsg) and kind is not AnyMsg:  # a C++ node reads it
            kind = self._messages[kind._type]
        key = subscription.topic, kind
        if key not in self._publications:
            self._publications[key] = _Publication(self._node, *key)
        return self._publications[key]

    def _listen(self, publication: Any) -> _Subscription:
        return _Subscription(self._node)

    def _publish(self, name: str, args: tuple[Any, ...], fields: Mapping[str, Any]) -> bool:
        """Publish as ``Publisher.publish`` does, but with errors that break no connection."""
        endpoints = [each for each in self._publications.values() if each.topic == name and each.connections]
        if not endpoints:
            return False
        data_class = next((endpoint.data_class for endpoint in endpoints if endpoint.data_class is not AnyMsg), None)
        if data_class:
            message = args_kwds_to_message(data_class, args, self._filled(data_class, fields))
        elif len(args) == 1 and hasattr(args[0], "_md5sum") and not fields:
            (message,) = args
        else:
            raise TypeError(f"{name} is subscribed to with rospy.AnyMsg, so publish a whole message there")
        for endpoint in endpoints:
            if endpoint.data_class is AnyMsg or endpoint.data_class._md5sum == message._md5sum:
                endpoint.send(message)
        return True

    def _offered(self, name: str) -> dict[str, str]:
        own = self._world.part(Services)
        services = self._node.master.services.items()
        return {name: server.class_of(name)._type for name, server in services if server is not own}

    def _request(
        self, name: str, args: tuple[Any, ...], fields: Mapping[str, Any], then: tester.Then | None
    ) -> Callable[[], None]:
        server = self._node.master.services[name]
        kind = server.class_of(name)
        request = args_kwds_to_message(kind._request_class, args, self._filled(kind._request_class, fields))
        _check(request)

        def send() -> None:
            connection = Connection(name, {"callerid": tester.NAME, "md5sum": kind._md5sum, "service": name})
            with suppress(TransportInitError):  # the node has gone without telling the master
                server.reach(connection)
                connection.ask(tester.NAME, server.node.world.recording, 1, request)

        return send

    def send_goal(self, action: str, fields: Mapping[str, Any]) -> None:
        """See the base. Raises LookupError: the actions of ROS 1 are not simulated."""
        raise LookupError(f"no node offers the action {action}: only ROS 2's are simulated")

    def _serve(self, name: str, srv_type: Any, handler: tester.Handler) -> None:
        with self._world.acting():
            Service(name, srv_type, partial(self._response, srv_type._response_class, handler))

    @staticmethod
    def _types(data_class: type[Message]) -> dict[str, str]:
        return dict(zip(data_class.__slots__, data_class._slot_types, strict=True))

    def _number(self, type_: str, value: float) -> Any:
        return TIMES[type_]._of(nanoseconds(value)) if type_ in TIMES else value

    def _nested(self, type_: str, fields: Mapping[str, Any]) -> Any:
        return TIMES[type_](**fields) if type_ in TIMES else super()._nested(type_, fields)


def _check(message: Message) -> None:
    try:
        serialize_message(0, message)
    except SerializationError as error:
        raise ROSSerializationException(str(error)) from None


class _Publication(Publication):
    delay = 0

    def send(self, message: Message) -> None:
        _check(message)  # an error here breaks no connection
        if self.data_class is AnyMsg:
            self.data_class, self.type = type(message), message._type
        self._send(message, self.connections)


class _Subscription:
    """A subscription and its only connection, which is there immediately.

    So no message is lost, and each is checked as if a node had received it.
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
    """Set a node's parameters before it runs; the caller acts for it. ``init_node`` sets private ones like ``~rate``.

    Raises what ``set_param`` does.
    """
    private = world.part(State).private_parameters
    for name, value in parameters.items():
        if rosgraph.is_private(name):
            private[name[1:]] = value
        else:
            client.set_param(name, value)
