"""Clients and services (sources: rclpy/client.py, rclpy/service.py, rmw_fastrtps).

On a real ROS a middleware carries requests and answers, as messages of two topics. Here the endpoints put copies of
them into each other's queues. Those in one process find each other immediately; :mod:`rosspin.rclpy.discovery` says how
others do.
"""

from __future__ import annotations

import itertools
import threading
import time
from collections import deque
from collections.abc import Callable
from contextlib import nullcontext, suppress
from functools import partial
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

from ..clocks.frames import warn
from ..messages.ros2 import Message, received, transfer
from ..messages.ros2 import Service as Interface
from ..world.graph import CallMade
from ..world.tester import NAME as TESTER
from .endpoints import Endpoint, Entity
from .exceptions import RCLError
from .qos import Policies, QoSProfile, incompatible_policy
from .service_introspection import Events, ServiceIntrospectionState
from .task import Future, await_or_execute
from .waits import waiting_for

if TYPE_CHECKING:
    from .callback_groups import CallbackGroup
    from .clock import Clock
    from .context import Context
    from .handle import RclNode

__all__ = ["Client", "Service"]

# How long (ns) a service tries to send an answer to a client that is not there.
_TRY = 100_000_000

# How often (s) wait_for_service and wait_for_server look.
_LOOK = 0.25


class ServiceEndpoints:
    """The clients and services of a run, by name. Its processes share them.

    ``asked`` are the full names of the nodes whose parameters someone has a client for, ``numbers`` the clients'.
    """

    def __init__(self) -> None:
        self.asked: set[str] = set()
        self.numbers = itertools.count(1)
        self._of: dict[str, list[Any]] = {}
        self._lock = threading.Lock()

    def add(self, endpoint: Any) -> list[Any]:
        """Add a client or service. Return what there is of the other kind already."""
        # In one go: of two endpoints that are made at the same time, exactly one finds the other.
        with self._lock:
            endpoints = self._of.setdefault(endpoint.entry.topic, [])
            same_type = [other for other in endpoints if other.entry.type == endpoint.entry.type]
            endpoints.append(endpoint)
        return [other for other in same_type if other.asks is not endpoint.asks]

    def offered(self) -> dict[str, ServerEndpoint]:
        """The services of the nodes, by their full names."""
        with self._lock:
            endpoints = list(chain.from_iterable(self._of.values()))
        return {each.entry.topic: each for each in endpoints if isinstance(each, ServerEndpoint)}

    def remove(self, endpoint: ServiceEndpoint) -> None:
        """Take an endpoint away; one that is not there is no error."""
        with suppress(ValueError):
            # Without the lock: the collector may call this while it is taken.
            self._of[endpoint.entry.topic].remove(endpoint)


class Header(NamedTuple):
    """Of a request: who asks, and with which number; whether the client could be answered when the service took it."""

    client: Any
    sequence: int
    call: CallMade
    is_known: bool = True


class ServiceEndpoint(Endpoint):
    """What is behind a client or a service."""

    asks: bool

    def __init__(self, node: RclNode, srv_type: type[Interface], full_name: str, qos: QoSProfile) -> None:
        super().__init__(node, srv_type, full_name, qos)
        self.srv_type = srv_type
        self.messages: deque[Any] = deque(maxlen=qos._rosspin_kept)
        self.events = Events(self, srv_type)
        self._offered, self._requested = Policies.offered(qos), Policies.requested(qos)
        self._transports: WeakKeyDictionary[Any, Any] = WeakKeyDictionary()  # from others, where a fault acts on them

    def join(self) -> None:
        """Find the other endpoints of the service, and be found."""
        for other in self.world.graph.part(ServiceEndpoints).add(self):
            if self.is_remote(other):
                self.introduce(other)
            else:
                self.meet(other)
                other.meet(self)

    def destroy(self) -> None:
        """See the base."""
        self.events.stop()
        super().destroy()

    def withdraw(self) -> None:
        """See the base."""
        self.world.graph.part(ServiceEndpoints).remove(self)

    def meet(self, other: Any) -> None:
        """Learn of another endpoint."""
        if not self.is_gone and not other.is_gone:
            self.peers.append(other)

    def _reaches(self, other: ServiceEndpoint) -> bool:
        """Whether what it sends arrives at another endpoint."""
        return other in self.peers and incompatible_policy(self._offered, other._requested) is None

    def _put(self, message: Any) -> None:
        self.messages.append(message)
        self.node.nudge()

    def _carry(self, other: Any, part: str, message: Message, arrive: Callable[[], object]) -> None:
        """Let a request or a response of another endpoint arrive: now, unless a fault of the run acts on it."""
        faults = self.world.graph.faults
        if faults is None or (isinstance(other, Endpoint) and not self.is_remote(other)):
            arrive()
            return
        if other not in self._transports:
            sender, here = other.node.full_name if isinstance(other, Endpoint) else TESTER, self.node.full_name
            reliable = self._requested.reliable
            self._transports[other] = faults.transport(self.entry.topic, sender, here, self.world, reliable, part)
        if transport := self._transports[other]:
            transport.send(lambda: message, arrive)
        else:
            arrive()

    def take(self) -> Any:
        """Return the oldest message, or None if there is none any more."""
        try:
            return None if self.is_destroyed else self.messages.popleft()
        except IndexError:
            return None


class ClientEndpoint(ServiceEndpoint):
    """What is behind a client."""

    asks = True

    def __init__(self, node: RclNode, srv_type: type[Interface], full_name: str, qos: QoSProfile) -> None:
        super().__init__(node, srv_type, full_name, qos)
        self.sent = 0  # how many requests
        self.gid = next(self.world.graph.part(ServiceEndpoints).numbers).to_bytes(16, "big")
        self.join()

    def send_request(self, request: Message) -> int:
        """Ask, and return the number that the answer will have."""
        message = transfer(request, self.srv_type.Request)
        self.sent += 1
        call = self.world.recording.add_call(self.entry.topic, self.node.full_name, lambda: message)
        for service in list(self.peers):
            if self._reaches(service):
                service.receive(message, Header(self, self.sent, call))
        self.events.tell(0, self.gid, self.sent, request=message)
        return self.sent

    def is_served(self) -> bool:
        """Whether a service is known. Raises RCLError after shutdown."""
        if not self.node.context.ok():
            raise RCLError("failed to check service availability: rcl node's context is invalid")
        return any(self._reaches(service) and service.reaches_back(self) for service in self.peers)

    def receive(self, service: Any, sequence: int, response: Message | None) -> None:
        """Take what a service sends. An answer to another client (None) wakes this one, too, for nothing."""
        if response is None:
            self._arrive(sequence, None)
        else:
            self._carry(service, "response", response, partial(self._arrive, sequence, response))

    def _arrive(self, sequence: int, response: Message | None) -> None:
        if not self.is_destroyed:
            self._put((sequence, response and received(response, self.srv_type.Response)))


class ServerEndpoint(ServiceEndpoint):
    """What is behind a service.

    It keeps the newest requests, as many as its QoS says, and hands out the oldest of these first.
    """

    asks = False

    def __init__(self, node: RclNode, srv_type: type[Interface], full_name: str, qos: QoSProfile) -> None:
        super().__init__(node, srv_type, full_name, qos)
        self._early: list[tuple[Message, Header]] = []  # from clients of other processes that are not known yet
        self.join()

    def receive(self, request: Message, header: Header) -> None:
        """Take a request that a client sends now."""
        self._carry(header.client, "request", request, partial(self._arrive, request, header))

    def _arrive(self, request: Message, header: Header) -> None:
        if self.is_destroyed:
            return
        if header.client in self.peers:
            self._put((received(request, self.srv_type.Request), header))
        else:
            self._early.append((request, header))

    def meet(self, other: Any) -> None:
        """See the base. What the client asked meanwhile is served."""
        super().meet(other)
        early, self._early = self._early, []
        for request, header in early:
            self._arrive(request, header)

    def reaches_back(self, client: ClientEndpoint) -> bool:
        """Whether a client gets the answers, as far as it knows."""
        return incompatible_policy(self._offered, client._requested) is None

    def accept(self, request: Message, header: Header) -> Header:
        """Begin to serve a request. Return its header, which now says whether the client can be answered."""
        self.events.tell(1, header.client.gid, header.sequence, request=request)
        return header._replace(is_known=self._reaches(header.client))

    def send_response(self, response: Message, header: Header) -> None:
        """Answer a request. If the client could not be reached when it was taken, wait 0.1 s for it, and warn.

        If it has gone since, do nothing. Raises InvalidHandle if the service was destroyed.
        """
        self.check()
        if not self._reaches(header.client):
            if not header.is_known:
                self.world.clock.sleep(_TRY)
                warn("failed to send response (timeout): client will not receive response", RuntimeWarning)
            return
        message = transfer(response, self.srv_type.Response)
        header.call.answer(self.node.full_name, self.world.clock.now(), lambda: message)
        for client in list(self.peers):
            if self._reaches(client):
                own = client is header.client
                client.receive(self, header.sequence if own else 0, message if own else None)
        self.events.tell(2, header.client.gid, header.sequence, response=message)


class _OfService(Entity):
    """What a client and a service have in common, as a node has them."""

    callback_group: CallbackGroup

    @property
    def service_name(self) -> str:
        """The service's full name."""
        self._rosspin.check()
        return str(self._rosspin.entry.topic)

    def configure_introspection(
        self, clock: Clock, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish each request and answer on ``<service>/_service_event``, at a clock's time, or stop it.

        Raises InvalidHandle if destroyed, AttributeError and TypeError for arguments of other types.
        """
        self._rosspin.check()
        self._rosspin.events.configure(clock, service_event_qos_profile, introspection_state)


class Client(_OfService):
    """Asks a service. Made by ``Node.create_client``. An executor has to spin its node, which takes the answers."""

    _rosspin: ClientEndpoint
    _rosspin_held = "_thread.lock"

    def __init__(
        self,
        context: Context,
        client_impl: ClientEndpoint,
        srv_type: type[Interface],
        srv_name: str,
        qos_profile: QoSProfile,
        callback_group: CallbackGroup,
    ) -> None:
        super().__init__(client_impl)
        self.context = context
        self.srv_type = srv_type
        self.srv_name = srv_name  # the name that the node gave
        self.qos_profile = qos_profile
        self._pending_requests: dict[int, Future] = {}
        self.callback_group = callback_group
        self._executor_event = False
        self._lock = threading.Lock()

    def call(self, request: Message, timeout_sec: float | None = None) -> Any:
        """Ask, wait for the answer while another thread spins, and return it; None if ``timeout_sec`` is over.

        Raises as ``call_async``. In a callback it waits without end if the answer has to wait for the callback's end.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError()
        answered = threading.Event()
        future = self.call_async(request)
        future.add_done_callback(lambda _: answered.set())
        with waiting_for(future, self._rosspin.world) if timeout_sec is None else nullcontext():
            if not future.done() and not answered.wait(timeout_sec):
                self.remove_pending_request(future)
        return future.result()

    def call_async(self, request: Message) -> Future:
        """Ask, and return a future of the answer. Without a service that is known, it is never done.

        Raises TypeError for a request of another class, InvalidHandle if the client was destroyed.
        """
        if not isinstance(request, self.srv_type.Request):
            raise TypeError()
        self._rosspin.check()
        future = Future()
        with self._lock:
            self._pending_requests[self._rosspin.send_request(request)] = future
        future.add_done_callback(self.remove_pending_request)
        return future

    def get_pending_request(self, sequence_number: int) -> Future:
        """Return the future of a request that is not answered; the first has the number 1. Raises KeyError."""
        with self._lock:
            return self._pending_requests[sequence_number]

    def remove_pending_request(self, future: Future) -> None:
        """Drop the answer to a request when it comes."""
        with self._lock:
            for sequence, pending in self._pending_requests.items():
                if pending is future:
                    del self._pending_requests[sequence]
                    break

    def service_is_ready(self) -> bool:
        """Whether a service is known. Raises InvalidHandle if the client was destroyed, RCLError after shutdown."""
        self._rosspin.check()
        return self._rosspin.is_served()

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Look for a service every 0.25 s, until these pauses add up to ``timeout_sec`` (default: no limit).

        Return whether it is known. Raises as ``service_is_ready``.
        """
        return look_until(self.service_is_ready, self.context, timeout_sec)

    def _rosspin_take(self) -> Any:
        """Return the call to make, or None if there is none any more."""
        message = self._rosspin.take()
        return message and (self._rosspin_settle, message, None)

    def _rosspin_settle(self, sequence: int, response: Message | None) -> None:
        endpoint = self._rosspin
        if response:
            endpoint.events.tell(3, endpoint.gid, sequence, response=response)
        with self._lock:
            future = self._pending_requests.get(sequence)
        if future:
            future._set_executor(endpoint.node.executor())
            future.set_result(response)


class Service(_OfService):
    """Lets an executor call ``callback(request, response)``, which returns the answer. Made by ``create_service``."""

    _rosspin: ServerEndpoint
    _rosspin_held = "Service"

    def __init__(
        self,
        service_impl: ServerEndpoint,
        srv_type: type[Interface],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
    ) -> None:
        super().__init__(service_impl)
        self.srv_type = srv_type
        self.srv_name = srv_name  # the name that the node gave
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self.qos_profile = qos_profile

    def send_response(self, response: Message, header: Header) -> None:
        """Answer a request. Raises TypeError for what is no response of this service, InvalidHandle if destroyed.

        If the client could not be reached when its request was taken, wait 0.1 s for it, and warn. If it has gone
        since, do nothing.
        """
        if not isinstance(response, self.srv_type.Response):
            raise TypeError()
        self._rosspin.check()
        if not isinstance(header, Header):
            raise TypeError()
        self._rosspin.send_response(response, header)

    def _rosspin_take(self) -> Any:
        """Return the call to make, or None if there is none any more."""
        message = self._rosspin.take()
        if message is None:
            return None
        request, header = message
        return self._rosspin_answer, (request, self._rosspin.accept(request, header)), None

    async def _rosspin_answer(self, request: Message, header: Header) -> None:
        self.send_response(await await_or_execute(self.callback, request, self.srv_type.Response()), header)


def look_until(is_ready: Callable[[], bool], context: Context | None, timeout_sec: float | None) -> bool:
    """Look every 0.25 s until something is ready, or these pauses add up to ``timeout_sec``. Return whether it is.

    With a ``context``, it also stops looking when that has ended.
    """
    left = float("inf") if timeout_sec is None else timeout_sec
    while (context is None or context.ok()) and not is_ready() and left > 0.0:
        time.sleep(_LOOK)
        left -= _LOOK
    return is_ready()
