"""Services and calls of them (sources: rospy/service.py, rospy/impl/tcpros_service.py).

On a real ROS a call asks the master which node has the service, and connects to that node. A thread there handles the
requests of this connection: one, or all if it persists. Here they go through two queues.
"""

from __future__ import annotations

import queue
import threading
import warnings
from collections.abc import Callable, Mapping
from functools import partial
from types import TracebackType
from typing import Any

from ..clocks.clock import nanoseconds
from ..clocks.frames import as_printed, node_frames
from ..messages import ros1
from ..messages.genpy import Duration
from ..messages.ros1 import DeserializationError, Message
from ..world.graph import CallMade, Recording, Transport
from ..world.world import NotSimulated, World, current, not_simulated, waiting_for
from . import names, rosgraph
from .core import logerr, logwarn, logwarn_throttle, may_register
from .exceptions import (
    ROSException,
    ROSInterruptException,
    TransportException,
    TransportInitError,
    TransportTerminated,
)
from .msg import args_kwds_to_message, serialize_message
from .state import State, state
from .topics import DEFAULT_BUFF_SIZE

__all__ = ["Service", "ServiceException", "ServiceProxy", "wait_for_service"]

# How long (ns) it takes to ask the master for a service and to connect to its node. On a real ROS an empty call took
# 3.7 ms (median of 300, in one process and between two), of which 0.3 ms on a connection that was there already.
FIND = 3_000_000

# How often (ns) wait_for_service and Service.spin look.
_LOOK = 300_000_000
_LOOK_OF_SPIN = 500_000_000

_HUNG_UP = "unable to receive data from sender, check sender's logs for details"


class ServiceException(Exception):
    """A call has failed. A handler raises it to tell the caller why it cannot answer."""


ServiceException.__module__ = "rospy.service"  # so that tracebacks name it as on a real ROS


class Services:
    """The services of one node, and the connections to them."""

    ROS = 1

    def __init__(self, world: World) -> None:
        self.node = world.part(State)
        self.is_gone = False  # whether its process has ended, perhaps without telling the master
        self._own: dict[str, Service] = {}
        self._connections: list[Connection] = []
        self._accepted: Connection | None = None  # the last one
        self.node.at_init.append(self._tell_master)
        self.node.before_shutdown.append(self._unregister_all)
        world.at_end.append(self._be_gone)

    def register(self, service: Service) -> None:
        """Add a service. Raises ServiceException if the node has one of that name; that one is kept."""
        name = service.resolved_name
        first = self._own.setdefault(name, service)
        if self.node.initialized:
            self._tell_master(name)
        if first is not service:
            raise ServiceException(f"service [{name}] already registered")

    def unregister(self, name: str, service: Service) -> None:
        """Take a service away. As the master knows of names and nodes only, a later one of this name is lost, too."""
        if self._own.get(name) is service:
            del self._own[name]
        if self.node.master.services.get(name) is self:
            del self.node.master.services[name]

    def _tell_master(self, *names: str) -> None:
        taken = [name for name in names or self._own if may_register("service", "service", name)]
        self.node.master.services.update(dict.fromkeys(taken, self))

    def _unregister_all(self) -> None:
        for name, service in list(self._own.items()):
            self.unregister(name, service)

    def _be_gone(self) -> None:
        self.is_gone = True
        for connection in self._connections:
            connection.hang_up()

    def class_of(self, name: str) -> type[ros1.Service]:
        """Return the class of one of the services."""
        return self._own[name].service_class

    def reach(self, connection: Connection | None) -> None:
        """Connect to the node. Raises TransportInitError if it has gone silently, or does not accept."""
        if self.is_gone:
            raise TransportInitError("[Errno 111] Connection refused")
        with self.node.world.acting():
            self._accept(connection)

    def _accept(self, connection: Connection | None) -> None:
        """Accept a connection; None is someone who only looks. Raises TransportInitError if it is of another type.

        One whose thread has ended without an answer is closed only now: rospy's server holds on to the last socket.
        """
        before, self._accepted = self._accepted, connection
        if before and before.is_left:
            self.close(before)
        if connection is None:
            return
        service, header = self._own[connection.name], connection.header
        md5sum = service.service_class._md5sum
        if header["md5sum"] not in (names.SERVICE_ANYTYPE, md5sum):
            sums = f"md5sums do not match: [{header['md5sum']}] vs. [{md5sum}]"
            reason = f"request from [{header['callerid']}]: {sums}"
            logwarn(f"Could not process inbound connection: {reason}{header}")
            raise TransportInitError(f"remote error reported: {reason}")
        kind = service.service_class._type
        connection.reply = {"callerid": self.node.name, "md5sum": md5sum, "service": connection.name, "type": kind}
        self._connections.append(connection)
        if faults := self.node.world.graph.faults:
            client, server = header["callerid"], self.node.name
            for part, names_ in (("request", (client, server)), ("response", (server, client))):
                connection.transports[part] = faults.transport(connection.name, *names_, self.node.world, None, part)
        self.node.world.start(threading.Thread(target=service.handle, args=(connection,), daemon=True))

    def close(self, connection: Connection) -> None:
        """Close a connection: whoever waits for an answer learns that none comes."""
        self._connections.remove(connection)
        connection.hang_up()

    def leave(self, connection: Connection) -> None:
        """Forget a connection whose thread ends because of an error."""
        connection.is_left = True
        if connection is not self._accepted:
            self.close(connection)


class Connection:
    """A connection from a proxy to a service: what each side has sent. ``header`` is what the proxy sends first."""

    def __init__(self, name: str, header: dict[str, str]) -> None:
        self.name = name
        self.header = header
        self.reply: dict[str, str] = {}  # the service's header
        self.persists = header.get("persistent", "").lower() in ("1", "true")
        self.is_left = False  # by the thread of the service
        self.transports: dict[str, Transport | None] = {
            "request": None,
            "response": None,
        }  # where a fault of the run acts on them
        self.handler: Any = None  # the stack of that thread, once it has begun
        self._is_closed = False
        self._requests: queue.SimpleQueue[tuple[bytes, CallMade] | None] = queue.SimpleQueue()
        self._answers: queue.SimpleQueue[tuple[bool, bytes] | None] = queue.SimpleQueue()
        self._spoilt: set[type[Message]] = set()  # what cannot be read any more: half a message is before it

    def ask(self, name: str, recording: Recording, seq: int, request: Message) -> None:
        """Send a request of a node. Raises what ``Message.serialize`` does; nothing can be sent after that."""
        if self._is_closed:
            raise AttributeError("'NoneType' object has no attribute 'tell'")  # rospy's buffer is gone
        data = self._bytes(seq, request)
        copy = _copy(request, data)
        self._pass_on("request", self._requests, (data, recording.add_call(self.name, name, copy)), copy)

    def next_request(self) -> tuple[bytes, CallMade]:
        """Wait for a request. Raises TransportTerminated if none comes."""
        if (found := self._requests.get()) is None:
            raise TransportTerminated(_HUNG_UP)
        return found

    def answer(self, service: Service, response: Message, call: CallMade) -> None:
        """Send a response. Raises what ``Message.serialize`` does; none can be read after that."""
        service.seq += 1
        data = self._bytes(service.seq, response)
        self._send(service._rosspin_node, False, data, call, _copy(response, data))

    def refuse(self, service: Service, reason: str, call: CallMade) -> None:
        """Send an error."""
        self._send(service._rosspin_node, True, reason.encode(), call, lambda: None)

    def _send(self, node: State, is_error: bool, data: bytes, call: CallMade, make: Callable[[], Any]) -> None:
        call.answer(node.name, node.clock.now(), make)
        self._pass_on("response", self._answers, (is_error, data), make)

    def _pass_on(self, part: str, line: queue.SimpleQueue[Any], what: Any, make: Callable[[], Any]) -> None:
        """Put into a queue what one side sends."""
        if transport := self.transports[part]:
            transport.send(make, partial(line.put, what))
        else:
            line.put(what)

    def _end(self, part: str, line: queue.SimpleQueue[Any]) -> None:
        """Let nothing come after what has been sent."""
        if transport := self.transports[part]:
            transport.follow(partial(line.put, None))
        else:
            line.put(None)

    def next_answer(self) -> tuple[bool, bytes]:
        """Wait for an error (True) or a response. Raises TransportTerminated if none comes."""
        with waiting_for(f"the answer of {self.name}", lambda: self.handler):
            found = self._answers.get()
        if found is None:
            raise TransportTerminated(_HUNG_UP)
        return found

    def hang_up(self) -> None:
        """Close the service's side."""
        self._end("response", self._answers)

    def close(self) -> None:
        """Close the proxy's side."""
        self._is_closed = True
        self._end("request", self._requests)

    def read(self, data_class: type[Message], data: bytes) -> Message:
        """Make a message from bytes. Raises TransportException if half of another is before it."""
        try:
            return data_class().deserialize(b"" if data_class in self._spoilt else data)
        except DeserializationError as error:
            raise TransportException(f"receive_once[{self.name}]: DeserializationError cannot deserialize: {error}")

    def _bytes(self, seq: int, message: Message) -> bytes:
        try:
            return serialize_message(seq, message)
        except Exception:
            self._spoilt.add(type(message))
            raise


def _copy(message: Message, data: bytes) -> Callable[[], Any]:
    """Return a function that makes the message from its bytes."""
    return lambda: type(message)().deserialize(data)


class _Named:
    """What Service and ServiceProxy have in common. Raises AttributeError if ``service_class`` is not a service's."""

    def __init__(self, name: str, service_class: type[ros1.Service]) -> None:
        self.resolved_name = names.resolve_name(name)
        self.service_class = service_class
        self.request_class = service_class._request_class
        self.response_class = service_class._response_class


class Service(_Named):
    """Answers the calls of the service ``name`` with what ``handler(request)`` returns, each in a thread of its own.

    The handler returns a response, or the values of its fields: as a list or tuple, by name in a dict, or the only one
    by itself. A ServiceException that it raises is told to the caller, and so is None, which is no answer. For any
    other exception ``error_handler(exception, type, exception, traceback)`` is called, which by default logs it; then
    the caller is told. ``buff_size`` has no effect. Raises ValueError if the name is empty or not a text, and
    ServiceException if the node has a service of that name.
    """

    def __init__(
        self,
        name: str,
        service_class: type[ros1.Service],
        handler: Callable[[Any], Any],
        buff_size: int = DEFAULT_BUFF_SIZE,
        error_handler: Callable[..., Any] | None = None,
    ) -> None:
        super().__init__(name, service_class)
        if not name or not isinstance(name, str):
            raise ValueError("service name is not a non-empty string")
        if not rosgraph.is_legal_name(name):
            warnings.warn(
                f"'{name}' is not a legal ROS graph resource name. This may cause problems with other ROS tools",
                stacklevel=2,
            )
        self.handler = handler
        if error_handler is not None:
            self.error_handler = error_handler  # type: ignore[method-assign]
        self.buff_size = buff_size
        self.seq = 0
        self.done = False
        self._rosspin_node = state()
        self._rosspin_services = self._rosspin_node.world.part(Services)
        self._rosspin_services.register(self)

    def error_handler(self, e: Exception, exc_type: type, exc_value: Exception, tb: TracebackType | None) -> None:
        """Log an exception of the handler."""
        self._rosspin_node.world.note_error(e)
        trace = [*as_printed(exc_value, node_frames(tb)).format()]
        logerr(f"Error processing request: {e}\n{trace}")

    def shutdown(self, reason: str = "") -> None:
        """Accept no more calls. Calls that have begun, or of persistent proxies, are answered."""
        self.done = True
        self._rosspin_services.unregister(self.resolved_name, self)

    def spin(self) -> None:
        """Wait until the service or the node is shut down. It handles no calls: these have threads of their own."""
        try:
            while not self._rosspin_node.shutdown and not self.done:
                self._rosspin_node.clock.sleep(_LOOK_OF_SPIN)
        except KeyboardInterrupt:
            pass

    def handle(self, connection: Connection) -> None:
        """Answer what comes through a connection, in its thread."""
        connection.handler = current()
        try:
            self._answer(connection)
            while connection.persists and not self._rosspin_node.shutdown:
                self._answer(connection)
        except TransportTerminated as error:
            if not connection.persists:
                logerr(f"incoming connection failed: {error}")
        except (Exception, SystemExit, KeyboardInterrupt):
            self._rosspin_services.leave(connection)
            raise
        self._rosspin_services.close(connection)

    def _answer(self, connection: Connection) -> None:
        data, call = connection.next_request()
        if self._rosspin_node.shutdown:
            return
        request = connection.read(self.request_class, data)
        request._connection_header = connection.header  # type: ignore[attr-defined]
        faults = self._rosspin_node.world.graph.faults
        if faults and faults.slows:
            faults.call(self._rosspin_node.name, self.handler)
        watcher = self._rosspin_node.world.recording.watcher
        if watcher:
            watcher.calls(self.handler)
        try:
            connection.answer(self, _to_response(self.handler(request), self.response_class), call)
        except NotSimulated:
            raise
        except ServiceException as error:
            connection.refuse(self, f"service cannot process request: {error}", call)
        except Exception as error:
            if lacking := not_simulated(error):
                raise lacking from error
            self.error_handler(error, type(error), error, error.__traceback__)
            connection.refuse(self, f"error processing request: {error}", call)
        finally:
            if watcher:
                watcher.ends(self.handler)


def _to_response(value: Any, response_class: type[Message]) -> Message:
    """Make a response from what a handler returns. Raises ServiceException for None and for wrong names or numbers."""
    if isinstance(value, Message) and value._type == response_class._type:
        return value
    if value is None:
        raise ServiceException("service handler returned None")
    if type(value) is dict:
        try:
            return response_class(**value)
        except AttributeError as error:
            raise ServiceException(f"handler returned invalid value: {error}")
    several = type(value) in (list, tuple)
    try:
        return response_class(*(value if several else [value]))
    except TypeError as error:
        what = "wrong number of values" if several else "invalid value"
        raise ServiceException(f"handler returned {what}: {error}")


class ServiceProxy(_Named):
    """Calls the service ``name``: ``proxy(request)``, or with the request's values in order or by keyword.

    A persistent proxy keeps its connection from the first call on, and so does not notice that the service has been
    replaced. ``headers`` are added to what the handler finds as ``request._connection_header``.
    """

    def __init__(
        self,
        name: str,
        service_class: type[ros1.Service],
        persistent: bool = False,
        headers: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(name, service_class)
        self.persistent = persistent
        self.seq = 0
        self.buff_size = DEFAULT_BUFF_SIZE
        self._headers = {**(headers or {}), **({"persistent": "1"} if persistent else {})}
        self._connection: Connection | None = None  # if it persists

    def wait_for_service(self, timeout: float | Duration | None = None) -> None:
        """Wait until the service is there, as :func:`wait_for_service` does."""
        wait_for_service(self.resolved_name, timeout)

    def __call__(self, *args: Any, **kwds: Any) -> Any:
        """Call the service, as ``call`` does."""
        return self.call(*args, **kwds)

    def call(self, *args: Any, **kwds: Any) -> Any:
        """Call the service and wait for its response, however long that takes.

        Raises TypeError or AttributeError for arguments that make no request, genpy's SerializationError for values of
        the wrong type, ServiceException if the service is not there, is of another type, or gives an error or nothing,
        and ROSInterruptException if its node ends while this one shuts down.
        """
        node = state()
        request = args_kwds_to_message(self.request_class, args, kwds)
        connection = self._connection or self._connect(node, request)
        self.seq += 1
        try:
            connection.ask(node.name, node.world.recording, self.seq, request)
        except Exception:
            if not self.persistent:
                connection.close()
            raise
        try:
            answer = None if node.shutdown else connection.next_answer()
            if answer is None or node.shutdown:
                raise ServiceException(f"service [{self.resolved_name}] returned no response")
            is_error, data = answer
            if is_error:
                raise ServiceException(f"service [{self.resolved_name}] responded with an error: {data!r}")
            response = connection.read(self.response_class, data)
        except TransportException as error:
            if node.shutdown:
                raise ROSInterruptException("node shutdown interrupted service call")
            raise ServiceException(f"transport error completing service call: {error}")
        response._connection_header = connection.reply  # type: ignore[attr-defined]
        return response

    def _connect(self, node: State, request: Message) -> Connection:
        if request._type != self.request_class._type:
            kinds = f"[{type(request)}] does not match service type [{self.request_class}]"
            raise TypeError(f"request object type {kinds}")
        if (server := self._rosspin_find(node)) is None:
            raise ServiceException(f"service [{self.resolved_name}] unavailable")
        own = {"callerid": node.name, "md5sum": self.service_class._md5sum, "service": self.resolved_name}
        connection = Connection(self.resolved_name, dict(sorted({**own, **self._headers}.items())))
        try:
            server.reach(connection)
        except TransportInitError as error:
            raise ServiceException(f"unable to connect to service: {error}")
        if self.persistent:
            self._connection = connection
        return connection

    def _rosspin_find(self, node: State) -> Services | None:
        return _find(node, self.resolved_name)

    def close(self) -> None:
        """Close the connection of a persistent proxy, for good: it cannot be called any more."""
        if self._connection is not None:
            self._connection.close()


def wait_for_service(service: str, timeout: float | Duration | None = None) -> None:
    """Wait until a service is there. It looks every 0.3 s.

    ``timeout`` is in seconds or a Duration. Raises ROSException if it is exceeded, ValueError if it is 0, and
    ROSInterruptException at shutdown.
    """
    node = state()
    seconds = timeout.to_sec() if isinstance(timeout, Duration) else timeout
    if seconds == 0:
        raise ValueError("timeout must be non-zero")
    name = names.resolve_name(service)
    until = None if seconds is None else node.clock.system() + nanoseconds(seconds)
    while not node.shutdown and (until is None or node.clock.system() < until):
        try:
            if server := _find(node, name):
                server.reach(None)
                return
        except TransportInitError:
            logwarn_throttle(10, f"wait_for_service({name}): failed to contact, will keep trying")
        node.clock.sleep(_LOOK)
    if node.shutdown:
        raise ROSInterruptException("rospy shutdown")
    raise ROSException(f"timeout exceeded while waiting for service {name}")


def _find(node: State, name: str) -> Services | None:
    """Ask the master for the node that has a service."""
    node.clock.sleep(FIND)
    found: Services | None = node.master.services.get(name)
    return found
