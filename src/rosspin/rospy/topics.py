"""Publishers, subscribers and the connections between them (source: rospy/topics.py and rospy/impl).

On a real ROS each pair of a publishing and a subscribing node has a TCP connection for each topic, even within one
process. A thread of the subscriber reads from it and runs the callbacks. Here that thread reads from a queue.
"""

from __future__ import annotations

import sys
import threading
import warnings
from collections import deque
from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar

from ..clocks.clock import LATE
from ..clocks.frames import format_error
from ..messages.ros1 import Message, SerializationError
from ..world.graph import Transport
from ..world.world import NotSimulated, World, not_simulated
from . import names, rosgraph
from .core import logerr, logwarn, may_register
from .exceptions import ROSException, ROSSerializationException
from .msg import args_kwds_to_message, serialize_message
from .state import State, state

__all__ = ["Publisher", "SubscribeListener", "Subscriber", "Topic"]

# How long (ns) two nodes take to connect, by who comes later: what was measured most often on a real ROS. A subscriber
# learns immediately who publishes, but the master tells subscribers of a new publisher only every 0.1 s.
LATER_SUBSCRIBER = 5_000_000
LATER_PUBLISHER = 100_000_000

DEFAULT_BUFF_SIZE = 65536

# On the wall clock, what a shutdown hook publishes is given these times (ns), one after the other, to arrive.
_ARRIVAL = (100_000,) * 10

Callbacks = list[tuple[Callable[..., Any], Any]]


class Publication:
    """A topic as one node publishes it. All its Publishers share this endpoint."""

    delay = LATER_SUBSCRIBER  # before a later subscriber is connected

    def __init__(self, node: State, topic: str, data_class: type[Message]) -> None:
        self.node = node
        self.topic = topic
        self.data_class = data_class
        self.type = data_class._type
        self.handles = 0  # Publishers that use it
        self.connections: list[Connection] = []
        self.listeners: list[SubscribeListener] = []
        self.latches = False
        self.closed = False
        self._latched: Message | None = None
        self._sequence = 0
        self._lock = threading.RLock()  # a signal handler may publish while its thread does
        self.recorded = node.world.recording.add_endpoint(topic, True)

    def register(self) -> None:
        """Tell the other nodes of this endpoint, unless the master does not take its name."""
        if not may_register("publication", "topic", self.topic):
            return
        for subscription in self.node.world.graph.advertise(self):
            subscription.connect(self, LATER_PUBLISHER)

    def reply(self) -> dict[str, str]:
        """Return the header that it sends to whoever connects."""
        return {
            "callerid": self.node.name,
            "latching": "1" if self.latches else "0",
            "md5sum": self.data_class._md5sum,
            "message_definition": self.data_class._full_text,
            "topic": self.topic,
            "type": self.type,
        }

    def accept(self, connection: Connection) -> bool:
        """Connect a subscriber unless it expects another type. Return whether it is connected."""
        wanted = connection.subscription.data_class
        if names.TOPIC_ANYTYPE not in (wanted._md5sum, self.data_class._md5sum) and wanted._md5sum != (
            self.data_class._md5sum
        ):
            self.refuse(connection)
            return False
        with self._lock:
            if self.closed:
                return False
            self.connections = [*self.connections, connection]

        def peer_publish(data: Message) -> None:
            self.publish(data, connection)

        for listener in self.listeners:
            listener.peer_subscribe(self.topic, self.publish, peer_publish)
        if self.latches and self._latched is not None:
            self._send(self._latched, [connection])
        return True

    def refuse(self, connection: Connection) -> None:
        """Say that a subscriber expects another type."""
        reason = f"topic types do not match: [{connection.subscription.data_class._type}] vs. [{self.type}]"
        logwarn("Could not process inbound connection: %s%s", reason, connection.subscription.request())

    def drop(self, connection: Connection) -> None:
        """Forget a connection."""
        with self._lock:
            if connection not in self.connections:
                return
            self.connections = [each for each in self.connections if each is not connection]
        for listener in self.listeners:
            listener.peer_unsubscribe(self.topic, len(self.connections))

    def publish(self, message: Message, only: Connection | None = None) -> None:
        """Publish to all who are connected, or only to one."""
        with self._lock:
            if self.closed:
                if not self.node.shutdown:
                    raise ROSException("publish() to a closed topic")
                return
            if self.latches:
                self._latched = message
            data = self._send(message, self.connections if only is None else [only])
            recording = self.node.world.recording
            if recording.published is not None:
                recording.add_message(self.topic, self.node.name, _copy(message, data))

    def _send(self, message: Message, connections: list[Connection]) -> bytes | None:
        """Send a message and return its bytes; None if no one is connected, as then it is not even looked at."""
        if not connections:
            return None
        self._sequence += 1
        try:
            data = serialize_message(self._sequence, message)
        except BaseException:
            # The part that rospy has written stays in its buffer: the next message arrives broken, and the subscriber
            # hangs up.
            for connection in self.connections:
                connection.broken = True
            raise
        for connection in connections:
            if connection.broken:
                self._break(connection)
            elif not self.node.shutdown:
                connection.deliver(data)
        return data

    def _break(self, connection: Connection) -> None:
        sys.stderr.write(
            f"rosspin: a message for {self.topic} that could not be sent has broken the connection to "
            f"{connection.subscription.node.name}, as on a real ROS: nothing more arrives there\n"
        )
        connection.close()

    def close(self) -> None:
        """End all connections. Messages on their way still arrive."""
        with self._lock:
            self.closed = True
        self.node.world.graph.remove(self)
        for connection in self.connections:
            connection.hang_up()
            self.drop(connection)
        self.listeners.clear()


class Subscription:
    """A topic as one node subscribes to it. All its Subscribers share this endpoint."""

    def __init__(self, node: State, topic: str, data_class: type[Message]) -> None:
        self.node = node
        self.topic = topic
        self.data_class = data_class
        self.type = data_class._type
        self.handles = 0
        self.callbacks: Callbacks = []
        self.connections: list[Connection] = []
        self.queue_size: int | None = None
        self.closed = False
        self.lock = threading.RLock()
        self.recorded = node.world.recording.add_endpoint(topic, False)
        faults = node.world.graph.faults
        self._slow = faults.call if faults and faults.slows else None

    def register(self) -> None:
        """Tell the other nodes of it, and connect to those that publish, unless the master refuses its name."""
        if not may_register("subscription", "topic", self.topic):
            return
        for publication in self.node.world.graph.subscribe(self):
            self.connect(publication, publication.delay)

    def connect(self, publication: Publication, delay: int) -> None:
        """Connect to a publisher after ``delay`` ns."""
        if delay and self.node.clock.explores:  # a test is connected immediately
            pair = f"{publication.node.name} to {self.node.name}: {self.topic}"
            delay += LATE * self.node.clock.choose([f"{pair} connects", f"{pair} connects late"])
        self.node.world.start(Connection(publication, self, delay))

    def request(self) -> dict[str, str]:
        """Return the header that it sends when it connects."""
        return {
            "callerid": self.node.name,
            "md5sum": self.data_class._md5sum,
            "message_definition": self.data_class._full_text,
            "tcp_nodelay": "0",
            "topic": self.topic,
            "type": self.type,
        }

    def set_queue_size(self, queue_size: int | None) -> None:
        """Keep only so many waiting messages, or all for -1. Raises ROSException for 0 and for non-integers."""
        if queue_size == 0:
            raise ROSException("queue size may not be set to zero")
        if queue_size is not None and type(queue_size) is not int:
            raise ROSException("queue size must be an integer")
        self.queue_size = None if queue_size == -1 else queue_size

    def add_callback(self, callback: Callable[..., Any], args: Any) -> None:
        """Call a function with each message, and immediately with the last message of each publisher that latches."""
        with self.lock:
            self.callbacks = [*self.callbacks, (callback, args)]
        for connection in self.connections:
            if connection.latched is not None:
                self._call(connection.latched, callback, args)

    def remove_callback(self, callback: Callable[..., Any], args: Any) -> None:
        """Stop calling a function, from the next messages on."""
        with self.lock:
            left = list(self.callbacks)
            left.remove((callback, args))
            self.callbacks = left

    def receive(self, messages: list[Message]) -> None:
        """Run the callbacks with each message."""
        callbacks = self.callbacks
        for message in messages:
            for callback, args in callbacks:
                self._call(message, callback, args)

    def _call(self, message: Message, callback: Callable[..., Any], args: Any) -> None:
        if self._slow:
            self._slow(self.node.name, callback)
        watcher = self.node.world.recording.watcher
        if watcher:
            watcher.calls(callback)
        try:
            if args is None:
                callback(message)
            else:
                callback(message, args)
        except NotSimulated:
            raise
        except Exception as error:
            if lacking := not_simulated(error):
                raise lacking from error
            if not self.node.shutdown:
                self.node.world.note_error(error)
                logerr(f"bad callback: {callback}\n{format_error(error)}")
        finally:
            if watcher:
                watcher.ends(callback)

    def close(self) -> None:
        """End all connections. Waiting messages are dropped."""
        with self.lock:
            self.closed = True
            connections, self.connections = self.connections, []
        self.node.world.graph.remove(self)
        for connection in connections:
            connection.close()


class Connection(threading.Thread):
    """A connection from a publishing to a subscribing node: the thread of the subscriber that runs its callbacks.

    Like rospy's, it reads all waiting messages, keeps the last ``queue_size``, and calls back with each of these before
    it reads again. A message sent at the very time at which it reads again has arrived.
    """

    def __init__(self, publication: Publication, subscription: Subscription, delay: int) -> None:
        super().__init__(name=publication.topic, daemon=True)
        self.publication = publication
        self.subscription = subscription
        self.latched: Message | None = None  # the last message of a publisher that latches
        self.broken = False
        self.idle = False
        self._delay = delay
        self._waiting: deque[bytes] = deque()
        self._is_last = False  # nothing more comes
        self._closed = False
        self._ready = threading.Lock()  # free when there is something to look at
        self._ready.acquire()

    @property
    def is_due(self) -> bool:
        """Whether it has something to read and nothing else to do."""
        return self.idle and bool(self._waiting)

    def deliver(self, data: bytes) -> None:
        """Put a message into the queue."""
        self._waiting.append(data)
        self._open()

    def _send_by(self, transport: Transport) -> None:
        """Let a transport carry what is delivered from now on, and the end after it."""
        deliver, hang_up, data_class = self.deliver, self.hang_up, self.publication.data_class
        self.deliver = lambda data: transport.send(  # type: ignore[method-assign]
            lambda: data_class().deserialize(data), lambda: deliver(data)
        )
        self.hang_up = lambda: transport.follow(hang_up)  # type: ignore[method-assign]

    def hang_up(self) -> None:
        """Close the publisher's side. Waiting messages still reach the callbacks."""
        self._is_last = True
        self._open()

    def close(self) -> None:
        """Close the subscriber's side. Waiting messages are dropped."""
        self._closed = True
        self._open()
        with self.publication.node.world.acting():
            self.publication.drop(self)

    def _open(self) -> None:
        try:
            self._ready.release()
        except RuntimeError:
            pass  # it is open

    def run(self) -> None:
        """Connect, and read until the connection ends."""
        subscription, publication = self.subscription, self.publication
        node, names = subscription.node, (publication.node.name, subscription.node.name)
        faults = node.world.graph.faults
        delay = faults.discovery_delay(*names) if faults and publication.node is not node else 0
        node.clock.sleep(self._delay + delay)
        with subscription.lock:
            if subscription.closed or publication.closed:
                return
            subscription.connections = [*subscription.connections, self]
        if faults and (transport := faults.transport(publication.topic, *names, node.world, None)):
            self._send_by(transport)
        with publication.node.world.acting():
            accepted = publication.accept(self)
        if accepted:
            publication.recorded.joined += 1
            subscription.recorded.joined += 1
            self._read()
            with subscription.lock:
                subscription.connections = [each for each in subscription.connections if each is not self]

    def _read(self) -> None:
        node, publication = self.subscription.node, self.publication
        header: dict[str, str] = {}
        while not (self._closed or node.shutdown):
            if not self._waiting:
                if self._is_last:
                    return
                self.idle = True
                self._ready.acquire()
                self.idle = False
                continue
            header = header or publication.reply()
            messages = [self._message(data, header) for data in self._take()]
            if publication.latches:
                self.latched = messages[-1]
            began = node.clock.now()
            try:
                self.subscription.receive(messages)
            except NotSimulated:
                raise
            except (Exception, SystemExit, KeyboardInterrupt):
                pass  # rospy says so in its log file only; the rest of the batch is gone
            if node.clock.now() != began:
                node.clock.sleep(0)  # let others send their messages of this time

    def _take(self) -> list[bytes]:
        batch = []
        while self._waiting:
            batch.append(self._waiting.popleft())
        return batch[-self.subscription.queue_size :] if self.subscription.queue_size else batch

    def _message(self, data: bytes, header: dict[str, str]) -> Message:
        message = self.subscription.data_class().deserialize(data)
        message._connection_header = header  # type: ignore[attr-defined]
        return message


def _copy(message: Message, data: bytes | None) -> Callable[[], Any]:
    """Return a function that copies a message as it is now, and as a subscriber would get it if it can be sent."""
    if data is None:
        from copy import deepcopy

        try:
            data = serialize_message(getattr(getattr(message, "header", None), "seq", 0), message)
        except Exception:
            kept = deepcopy(message)  # it cannot be sent, but no one was connected
            return lambda: kept
    return partial(_received, type(message), data)


def _received(kind: type[Message], data: bytes) -> Message:
    return kind().deserialize(data)


# --- a node's topics --------------------------------------------------------------------------------------------------

Impl = TypeVar("Impl", Publication, Subscription)


class Topics:
    """The topics of one node."""

    ROS = 1

    def __init__(self, world: World) -> None:
        self.node = world.part(State)
        self.publications: dict[str, Publication] = {}
        self.subscriptions: dict[str, Subscription] = {}
        self._unknown: list[Publication | Subscription] = []  # endpoints that the other nodes do not know yet
        self._lock = threading.RLock()
        self.node.at_init.append(self.register)
        self.node.before_shutdown.append(self._let_arrive)
        self.node.at_shutdown.append(self._close_all)
        world.at_end.append(self._close_all)

    def acquire(self, kind: type[Impl], endpoints: dict[str, Impl], topic: str, data_class: type[Message]) -> Impl:
        """Return the node's endpoint of a topic for one more handle, which registers the end once it is complete."""
        with self._lock:
            endpoint = endpoints.get(topic)
            if endpoint is None:
                endpoint = endpoints[topic] = kind(self.node, topic, data_class)
                self._unknown.append(endpoint)
            endpoint.handles += 1
            return endpoint

    def release(self, endpoints: dict[str, Impl], endpoint: Impl) -> None:
        """Give up a handle. The last one closes the endpoint."""
        with self._lock:
            if self.node.shutdown:
                return
            endpoint.handles -= 1
            if endpoint.handles == 0:
                del endpoints[endpoint.topic]
                endpoint.close()

    def register(self) -> None:
        """Tell the other nodes of new endpoints, once this one is initialised."""
        with self._lock:
            while self._unknown and self.node.initialized:
                endpoint = self._unknown.pop(0)
                if not endpoint.closed:
                    endpoint.register()

    def _let_arrive(self) -> None:
        """Wait until what shutdown hooks have published has arrived in this node, too."""
        for pause in (0, *_ARRIVAL):  # in simulated time they arrive in no time
            endpoints = list(self.subscriptions.values())
            if not any(connection.is_due for endpoint in endpoints for connection in endpoint.connections):
                return
            self.node.clock.sleep(pause)

    def _close_all(self) -> None:
        with self._lock:
            endpoints: list[Publication | Subscription] = [*self.publications.values(), *self.subscriptions.values()]
            for endpoint in endpoints:
                endpoint.close()


class Topic:
    """What Publisher and Subscriber have in common.

    Raises ValueError if the name is empty or not a text, or if ``data_class`` is not the class of a message.
    """

    def __init__(self, name: str, data_class: type[Message], reg_type: str) -> None:
        if not name or not isinstance(name, str):
            raise ValueError("topic name is not a non-empty string")
        if data_class is None:
            raise ValueError("topic parameter 'data_class' is not initialized")
        if type(data_class) is not type:
            raise ValueError(f"data_class [{data_class}] is not a class")
        if not issubclass(data_class, Message):
            raise ValueError(f"data_class [{type(data_class).__name__}] is not a message data class")
        if not rosgraph.is_legal_name(name):
            warnings.warn(
                f"'{name}' is not a legal ROS graph resource name. This may cause problems with other ROS tools",
                stacklevel=3,
            )
        node = state()
        resolve = names.resolve_name if node.initialized else names.resolve_name_without_node_name
        self.resolved_name: str | None = resolve(name)
        self.name = self.resolved_name
        self.data_class: type[Message] | None = data_class
        self.type: str | None = data_class._type
        self.md5sum: str | None = data_class._md5sum
        self.reg_type = reg_type
        self._topics = node.world.part(Topics)
        self.impl: Any = None

    def get_num_connections(self) -> int:
        """Return how many nodes this one is connected to on the topic."""
        return len(self.impl.connections)

    def _forget(self) -> None:
        self.impl = self.resolved_name = self.type = self.md5sum = self.data_class = None


class Publisher(Topic):
    """Publishes messages of the class ``data_class`` on the topic ``name``.

    Other nodes take a while to connect; what is published before is lost. With ``latch`` the last message is kept and
    sent to whoever connects. ``subscriber_listener`` is told who connects. Without a ``queue_size`` there is a warning,
    but the queue loses nothing here, whatever its size; the real one loses messages that come in bursts.
    ``tcp_nodelay`` and ``headers`` have no effect.
    """

    impl: Publication | None
    _rosspin_endpoint = Publication  # the class of the node's endpoint

    def __init__(
        self,
        name: str,
        data_class: type[Message],
        subscriber_listener: SubscribeListener | None = None,
        tcp_nodelay: bool = False,
        latch: bool = False,
        headers: dict[str, str] | None = None,
        queue_size: int | None = None,
    ) -> None:
        super().__init__(name, data_class, "pub")
        assert self.resolved_name
        self.impl = self._topics.acquire(
            self._rosspin_endpoint, self._topics.publications, self.resolved_name, data_class
        )
        if subscriber_listener:
            self.impl.listeners.append(subscriber_listener)
        if latch:
            self.impl.latches = True
        self._topics.register()
        if queue_size is None:
            warnings.warn(
                "The publisher should be created with an explicit keyword argument 'queue_size'. "
                "Please see http://wiki.ros.org/rospy/Overview/Publishers%20and%20Subscribers for more information.",
                SyntaxWarning,
                stacklevel=2,
            )

    def publish(self, *args: Any, **kwds: Any) -> None:
        """Publish a message, or one made from field values: all of them in order, or some by keyword.

        Raises ROSException before ``init_node`` and after ``unregister``, and TypeError or AttributeError for arguments
        that make no message. If anyone is connected, values of the wrong type raise ROSSerializationException and
        break the connections. After shutdown nothing happens.
        """
        if self.impl is None:
            raise ROSException("publish() to an unregistered() handle")
        assert self.data_class
        if not self.impl.node.initialized:
            raise ROSException("ROS node has not been initialized yet. Please call init_node() first")
        message = args_kwds_to_message(self.data_class, args, kwds)
        try:
            self.impl.publish(message)
        except SerializationError as error:
            raise ROSSerializationException(str(error))

    def unregister(self) -> None:
        """Publish no more. What was published still arrives."""
        if self.impl is not None:
            self._topics.release(self._topics.publications, self.impl)
            self._forget()


class Subscriber(Topic):
    """Calls ``callback(message)`` with each message on the topic ``name``, in a thread of its own for each publisher.

    If ``callback_args`` is not None, it is the callback's second argument. Messages that come while a callback runs
    wait; the last ``queue_size`` of them are taken next, or all. A node's Subscribers to one topic share its threads
    and its ``queue_size``; their callbacks are called one after the other. An exception in a callback is logged, and
    all continues. ``buff_size`` and ``tcp_nodelay`` have no effect. Raises ROSException for a ``queue_size`` of 0.
    """

    impl: Subscription | None
    _rosspin_endpoint = Subscription  # the class of the node's endpoint

    def __init__(
        self,
        name: str,
        data_class: type[Message],
        callback: Callable[..., Any] | None = None,
        callback_args: Any = None,
        queue_size: int | None = None,
        buff_size: int = DEFAULT_BUFF_SIZE,
        tcp_nodelay: bool = False,
    ) -> None:
        super().__init__(name, data_class, "sub")
        assert self.resolved_name
        self.impl = self._topics.acquire(
            self._rosspin_endpoint, self._topics.subscriptions, self.resolved_name, data_class
        )
        if queue_size is not None:
            self.impl.set_queue_size(queue_size)
        self.callback = callback
        self.callback_args = callback_args if callback is not None else None
        if callback is not None:
            self.impl.add_callback(callback, callback_args)
        self._topics.register()

    def unregister(self) -> None:
        """Call the callback no more."""
        if self.impl is not None:
            if self.callback is not None:
                self.impl.remove_callback(self.callback, self.callback_args)
            self.callback = self.callback_args = None
            self._topics.release(self._topics.subscriptions, self.impl)
            self._forget()


class SubscribeListener:
    """Is told which nodes connect to a publisher, and which leave. Override its methods, which do nothing."""

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[Any], Any], peer_publish: Callable[[Any], Any]
    ) -> None:
        """Called when a node connects. ``peer_publish(message)`` publishes to it alone, ``topic_publish`` to all."""

    def peer_unsubscribe(self, topic_name: str, num_peers: int) -> None:
        """Called when a node leaves; ``num_peers`` are left."""
