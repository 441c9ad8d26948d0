"""What a C++ node of ROS 1 asks its host: it has a name, topics and parameters among the nodes in Python.

roscpp's own queues, timers and names are in the program (``runtime/roscpp.cpp``). What is shared is rospy's
stand-in: both find each other on one graph, connect by the same rules, and have one parameter server.
"""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Mapping
from importlib import import_module
from itertools import count
from typing import Any

from ..messages.ros1 import Message
from ..rospy import client
from ..rospy.exceptions import ROSException, TransportException
from ..rospy.master import get_master
from ..rospy.msg import AnyMsg
from ..rospy.service import Connection as Calls
from ..rospy.service import Service, ServiceException, ServiceProxy, Services
from ..rospy.state import State
from ..rospy.topics import Connection, Publication, Publisher, Subscriber, Subscription
from ..world.world import World

__all__ = ["Ros1"]

Event = Callable[[str, list[Any]], None]


class Ros1:
    """The answers to a node in its ``world``. ``event(what, values)`` gives something to the node when it comes."""

    def __init__(self, world: World, event: Event) -> None:
        self._world = world
        self._event = event
        self._publishers: list[Publisher] = []
        self._subscribers: list[Subscriber] = []
        self._kinds: list[str] = []  # of what they hear
        self._links: list[Connection] = []  # of which the node was told
        self._services: dict[str, _Service] = {}
        self._proxies: dict[int, _Proxy] = {}
        self._numbers = count()
        self._lines: dict[int, queue.SimpleQueue[tuple[bool, bytes]]] = {}  # for what it answers
        self._asked: dict[str, Callable[..., Any]] = {
            "init": self._init,
            "advertise": self._advertise,
            "nodes": _nodes,
            "topics": client.get_published_topics,
            "subscribers": lambda number: self._publishers[number].get_num_connections(),
            "subscribe": self._subscribe,
            "publishers": lambda number: self._subscribers[number].get_num_connections(),
            "advertise_service": self._advertise_service,
            "service_exists": lambda name: name in self._node.master.services,
            "get_param": lambda name: client.get_param(name, None),
            "set_param": client.set_param,
            "has_param": client.has_param,
            "delete_param": self._delete_param,
            "search_param": _search_param,
            "param_names": client.get_param_names,
        }
        self._handlers: dict[str, Callable[..., object]] = {
            "publish": self._publish,
            "publish_to": self._publish_to,
            "unadvertise": lambda number: self._publishers[number].unregister(),
            "unsubscribe": lambda number: self._subscribers[number].unregister(),
            "unadvertise_service": lambda name: self._services.pop(name).shutdown(),
            "respond": lambda number, is_ok, data: self._lines.pop(number).put((is_ok, data)),
            "call": self._call,
            "shutdown": self._shutdown,
        }

    def answer(self, what: str, values: list[Any]) -> Any:
        """Answer what the node asks."""
        return self._asked[what](*values)

    def take(self, what: str, values: list[Any]) -> None:
        """Do what the node has told."""
        self._handlers[what](*values)

    def message(self, subscriber: int, data: bytes) -> Any:
        """Return a message that a subscriber was given."""
        return _class(self._kinds[subscriber])().deserialize(data)

    @property
    def _node(self) -> State:
        return self._world.part(State)

    def _init(self, name: str, parameters: Mapping[str, str], has_rosout: bool) -> None:
        for parameter, text in parameters.items():
            client.set_param(parameter, _from_command_line(text))
        client.begin_node(name, {}, follows_clock=False)
        self._node.rosout = has_rosout
        self._node.at_shutdown.append(lambda: self._event("shutdown", []))

    def _shutdown(self) -> None:
        node = self._node
        if not node.shutdown:
            node.shutdown_requested = node.shutdown = True
            for close in node.at_shutdown:
                close()

    # --- topics ---

    def _advertise(self, topic: str, kind: str, queue_size: int, latch: bool, is_told: bool) -> int:
        number = len(self._publishers)

        def tell(connects: bool, connection: Connection) -> None:
            if connects:
                self._links.append(connection)
            self._event("connect", [number, connects, connection.subscription.node.name, self._links.index(connection)])

        def refuse(wanted: Subscription) -> None:
            client = "" if wanted.node is self._node else wanted.node.name
            own = _class(kind)
            types = [wanted.type, wanted.data_class._md5sum, own._type, own._md5sum]
            self._event("refused", [client, topic, *types])

        self._publishers.append(_Publisher(topic, _class(kind), latch=latch, queue_size=queue_size))
        endpoint = self._publishers[-1].impl
        if isinstance(endpoint, _Publication):
            endpoint.refusals.append(refuse)
            if is_told:
                endpoint.callbacks.append(tell)
                for connection in endpoint.connections:
                    tell(True, connection)
        return number

    def _publish(self, number: int, data: bytes) -> None:
        publisher = self._publishers[number]
        if publisher.data_class:  # it may have been ended meanwhile
            publisher.publish(publisher.data_class().deserialize(data))

    def _publish_to(self, number: int, link: int, data: bytes) -> None:
        endpoint = self._publishers[number].impl
        if isinstance(endpoint, _Publication) and (connection := self._links[link]) in endpoint.connections:
            endpoint.publish_to(endpoint.data_class().deserialize(data), connection)

    def _subscribe(self, topic: str, kind: str) -> int:
        number = len(self._subscribers)
        self._kinds.append(kind)

        def receive(message: Any) -> None:
            self._event("message", [number, message._buff, message._connection_header["callerid"]])

        self._subscribers.append(_Subscriber(topic, _bytes_of(_class(kind)), receive))
        return number

    # --- services ---

    def _advertise_service(self, name: str, request: str) -> None:
        self._services[name] = _Service(name, _service(request), self._answer)

    def _answer(self, name: str, data: bytes, caller: str) -> tuple[bool, bytes]:
        """Give a request to the program, and wait for its response: whether it is one, and its bytes."""
        number, line = next(self._numbers), queue.SimpleQueue[tuple[bool, bytes]]()
        self._lines[number] = line
        self._event("request", [name, number, data, caller])
        return line.get()

    def _call(self, number: int, client: int, persistent: bool, name: str, request: str, data: bytes) -> None:
        proxy = self._proxies.get(client) or _Proxy(name, _service(request), persistent)
        self._proxies[client] = proxy

        def call() -> None:
            try:
                message = proxy.request_class().deserialize(data)
                connection = proxy._connection or proxy._connect(self._node, message)
                proxy.seq += 1
                connection.ask(self._node.name, self._world.recording, proxy.seq, message)
                is_error, answer = connection.next_answer()
                self._event("response", [number, True, not is_error, answer])
            except (ServiceException, TransportException):
                self._event("response", [number, False, False, b""])

        self._world.start(threading.Thread(target=call, daemon=True))

    # --- parameters ---

    def _delete_param(self, name: str) -> bool:
        try:
            client.delete_param(name)
        except KeyError:
            return False
        return True


def _nodes() -> list[str]:
    _, _, kinds = get_master().getSystemState()
    return sorted({node for kind in kinds for _, nodes in kind for node in nodes})


def _search_param(namespace: str, name: str) -> str | None:
    try:
        return client.search_from(namespace.rstrip("/"), name)
    except ROSException:  # a private name, of which roscpp does not complain
        return None


def _from_command_line(text: str) -> Any:
    """Read the value of ``_name:=value`` as roscpp does: an integer, a number, a bool, or else a text.

    Source: roscpp/param.cpp, ``init``.
    """
    if text == text.strip() and "_" not in text:
        for kind in (int, float):
            try:
                return kind(text)
            except ValueError:
                pass
    return {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}.get(text, text)


def _class(kind: str) -> type[Message]:
    """Return the class of a message, as in std_msgs/UInt32."""
    package, _, name = kind.partition("/")
    found: type[Message] = getattr(import_module(f"{package}.msg"), name)
    return found


def _service(request: str) -> Any:
    """Return the class of the service that has a request, as in std_srvs/TriggerRequest."""
    package, _, name = request.removesuffix("Request").partition("/")
    return getattr(import_module(f"{package}.srv"), name)


def _bytes_of(data_class: type[Message]) -> type[AnyMsg]:
    """Make a class of messages that are left as the bytes that they are sent as, but only of one type."""
    fields = ("_type", "_md5sum", "_full_text")
    own = {name: getattr(data_class, name) for name in fields}
    return type(data_class.__name__, (AnyMsg,), {"__slots__": [], **own})


def _ignore(request: object) -> None:
    """Stand in for a handler: the program is asked otherwise."""


class _Local(Connection):
    """A connection within a node. Its messages arrive when they are published (source: intraprocess_publisher_link)."""

    def deliver(self, data: bytes) -> None:
        message = self.subscription.data_class().deserialize(data)
        message._connection_header = self.publication.reply()  # type: ignore[attr-defined]
        if self.publication.latches:
            self.latched = message
        self.subscription.receive([message])

    def hang_up(self) -> None:
        own = self.subscription
        own.connections = [each for each in own.connections if each is not self]


class _Publication(Publication):
    """A topic as a C++ node publishes it: ``callbacks`` get whether a connection is made, or ends, and the connection.

    ``refusals`` get a subscription of another type.
    """

    def __init__(self, node: State, topic: str, data_class: type[Message]) -> None:
        super().__init__(node, topic, data_class)
        self.callbacks: list[Callable[[bool, Connection], None]] = []
        self.refusals: list[Callable[[Subscription], None]] = []

    def accept(self, connection: Connection) -> bool:
        is_accepted = super().accept(connection)
        if is_accepted:
            for tell in self.callbacks:
                tell(True, connection)
        return is_accepted

    def refuse(self, connection: Connection) -> None:
        for tell in self.refusals:
            tell(connection.subscription)

    def drop(self, connection: Connection) -> None:
        if connection in self.connections and not self.closed:
            for tell in self.callbacks:
                tell(False, connection)
        super().drop(connection)

    def publish_to(self, message: Message, connection: Connection) -> None:
        """Publish to one; whoever connects later is not given that."""
        with self._lock:
            latched = self._latched
            self.publish(message, connection)
            self._latched = latched


class _Publisher(Publisher):
    _rosspin_endpoint = _Publication


class _Subscription(Subscription):
    """A topic as a C++ node subscribes to it: to its own publishers it is connected at once."""

    def request(self) -> dict[str, str]:
        header = super().request()
        del header["message_definition"]  # which roscpp does not send (source: transport_publisher_link.cpp)
        return header

    def connect(self, publication: Publication, delay: int) -> None:
        if publication.node is not self.node:
            super().connect(publication, delay)
            return
        connection = _Local(publication, self, 0)
        self.connections = [*self.connections, connection]
        if not publication.accept(connection):
            connection.hang_up()


class _Subscriber(Subscriber):
    _rosspin_endpoint = _Subscription


class _Service(Service):
    """A service of a C++ node: ``ask`` gives the program a request."""

    def __init__(self, name: str, service_class: Any, ask: Callable[[str, bytes, str], tuple[bool, bytes]]) -> None:
        super().__init__(name, service_class, _ignore)
        self._ask = ask

    def _answer(self, connection: Calls) -> None:
        data, call = connection.next_request()
        is_ok, response = self._ask(self.resolved_name, data, connection.header["callerid"])
        if is_ok:
            connection.answer(self, self.response_class().deserialize(response), call)
        else:
            connection.refuse(self, response.decode(errors="replace"), call)


class _Proxy(ServiceProxy):
    """Calls a service for a C++ node, which has waited for as long as the search takes."""

    def _rosspin_find(self, node: State) -> Services | None:
        found: Services | None = node.master.services.get(self.resolved_name)
        return found
