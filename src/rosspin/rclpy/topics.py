"""Publishers and subscriptions (sources: rclpy/publisher.py, rclpy/subscription.py, rclpy/wait_for_message.py).

On a real ROS a middleware carries the messages. Here a publisher puts copies of them into the subscriptions' queues.
The endpoints in one process find each other immediately; :mod:`rosspin.rclpy.discovery` says how others do.
"""

from __future__ import annotations

import inspect
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from functools import partial
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from ..messages import cdr
from ..messages.ros2 import Message, received, transfer
from ..world.graph import Transport
from ..world.tester import NAME as TESTER
from .callback_groups import ReentrantCallbackGroup
from .deadlines import Countdown, Lasting
from .discovery import KEPT
from .endpoints import Endpoint, Entity
from .event import Event
from .event_handler import (
    EventHandler,
    PublisherEventCallbacks,
    QoSPublisherEventType,
    QoSSubscriptionEventType,
    SubscriptionEventCallbacks,
)
from .exceptions import RCLError, invalid_context
from .qos import FOR_EVER, Policies, QoSPolicyKind, QoSProfile, incompatible_policy, length

if TYPE_CHECKING:
    from enum import IntEnum

    from .callback_groups import CallbackGroup
    from .handle import RclNode
    from .node import Node

__all__ = ["Publisher", "Subscription", "wait_for_message"]


class TopicEndpoint(Endpoint):
    """What a publisher and a subscription have in common."""

    def __init__(
        self,
        node: RclNode,
        msg_type: type[Message],
        full_name: str,
        qos: QoSProfile,
        policies: Policies,
    ) -> None:
        super().__init__(node, msg_type, full_name, qos)
        self.msg_type = msg_type
        self.policies = policies
        self.recorded = self.world.recording.add_endpoint(full_name, isinstance(self, PublisherEndpoint), qos)

    def _queue(self, most: int | None, qos: QoSProfile, sent: Callable[[Any], int]) -> deque[Any]:
        """Make a queue for so many messages, which drops those older than the lifespan."""
        lifespan = length(qos.lifespan)
        return deque(maxlen=most) if lifespan == FOR_EVER else Lasting(most, lifespan, self.world.clock, sent)

    # Its events.
    DEADLINE: IntEnum
    INCOMPATIBLE: IntEnum
    LIVELINESS: IntEnum
    MATCHED: IntEnum

    def _handler(self, event_type: IntEnum) -> EventHandler | None:
        handlers = getattr(self.entity(), "_rosspin_handlers", ())
        return next((handler for handler in handlers if handler.event_type is event_type), None)

    def tell(self, event_type: IntEnum, policy: QoSPolicyKind = QoSPolicyKind.INVALID, **changes: int) -> None:
        """Tell an event to the node's callback, if it has one."""
        if handler := self._handler(event_type):
            handler._rosspin_happen(policy, **changes)

    def refuse(self, policy: QoSPolicyKind) -> None:
        """Let the node know, when it spins, by which policy another endpoint does not match."""
        self.recorded.refused += 1
        self.tell(self.INCOMPATIBLE, policy, total=1)

    def _countdown(self, event_type: IntEnum, period: int, again: bool = False) -> list[Countdown]:
        """Make what tells an event after a period (ns), in a list; none if that has no end, or of no interest."""
        if period == FOR_EVER or not self._handler(event_type):
            return []
        return [Countdown(self.world, period, lambda: self.tell(event_type, total=1), again)]

    def withdraw(self) -> None:
        """See the base."""
        self.world.graph.remove(self.entry)

    def meet(self, other: Any, policy: QoSPolicyKind | None) -> None:
        """Learn of an endpoint in another process. ``policy`` is the one by which the two do not match, or None."""
        if self.is_gone or other.is_gone:
            return
        if policy:
            self.refuse(policy)
        else:
            self.join(other)

    def join(self, other: Any) -> None:
        """Be connected to another endpoint."""
        self.recorded.joined += 1
        self.peers.append(other)
        self.tell(self.MATCHED, total=1, current=1)

    def part(self, other: Any) -> None:
        if other in self.peers:
            super().part(other)
            self.tell(self.MATCHED, current=-1)


class PublisherEndpoint(TopicEndpoint):
    """What is behind a publisher, and what rcl publishes with. :meth:`begin` follows once it can be told events."""

    DEADLINE = QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED
    INCOMPATIBLE = QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS
    LIVELINESS = QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST
    MATCHED = QoSPublisherEventType.RCL_PUBLISHER_MATCHED

    def __init__(self, node: RclNode, msg_type: type[Message], full_name: str, qos: QoSProfile) -> None:
        super().__init__(node, msg_type, full_name, qos, Policies.offered(qos))

    def begin(self) -> PublisherEndpoint:
        """Find the subscriptions, and be found. Return itself."""
        qos = self.qos_profile
        subscriptions = [entry.endpoint for entry in self.world.graph.advertise(self.entry)]
        self.policies = Policies.offered(
            qos, [each.policies for each in subscriptions if isinstance(each, TopicEndpoint)]
        )
        most = qos._rosspin_kept if self.policies.transient_local else 0
        self.kept = self._queue(most, qos, itemgetter(1))  # the messages, and when (ns) each was sent
        lease = self.policies.lease if self.policies.manual else FOR_EVER
        self._lease = self._countdown(self.LIVELINESS, lease)
        self._watches = [*self._lease, *self._countdown(self.DEADLINE, self.policies.deadline, again=True)]
        for subscription in subscriptions:
            if self.is_remote(subscription):
                _discover(self, subscription)
            else:
                _connect(self, subscription, subscription, self)
        return self

    def check_context(self, failed: str) -> None:
        """Raise InvalidHandle if it was destroyed, RCLError after shutdown."""
        self.check()
        if not self.node.context.ok():
            raise RCLError(f"{failed}: publisher's context is invalid")

    def publish(self, msg: Message | bytes) -> None:
        """Publish a message, or the bytes of one. Raises RCLError after shutdown."""
        if not self.node.context.ok():
            raise RCLError("Failed to publish: publisher's context is invalid")
        message = msg if isinstance(msg, bytes) else transfer(msg, self.msg_type)
        sent = self.world.clock.system()
        self.kept.append((message, sent))
        for watch in self._watches:
            watch.restart()
        recording = self.world.recording
        if recording.published is not None:
            with suppress(cdr.CDRError):
                received = cdr.deserialize(message, self.msg_type) if isinstance(message, bytes) else message
                recording.add_message(self.entry.topic, self.node.full_name, lambda: received)
        for subscription in list(self.peers):
            subscription.receive(self, message, sent)

    def fall_silent(self) -> None:
        """Be alive no more: its process was killed."""
        for subscription in self.peers:
            if self.is_remote(subscription):
                subscription.miss(self)

    def assert_liveliness(self) -> None:
        """Say that it is alive, which counts if its liveliness is ``MANUAL_BY_TOPIC``."""
        if self.policies.manual:
            for lease in self._lease:
                lease.restart()
            for subscription in self.peers:
                subscription.hear(self)

    def wait_for_all_acked(self, timeout: Any) -> bool:
        """Wait until what was published has arrived, and return whether it has."""
        clock = self.world.clock
        last = max((peer.expects(self) for peer in self.peers if isinstance(peer, SubscriptionEndpoint)), default=0)
        left = max(last - clock.now(), 0)
        most = left if timeout is None or timeout.nanoseconds < 0 else min(left, timeout.nanoseconds)
        if most:
            clock.sleep(most)
        return most == left


class SubscriptionEndpoint(TopicEndpoint):
    """What is behind a subscription. :meth:`begin` follows once it can be told events.

    It keeps the newest messages, as many as its QoS says, and hands out the oldest of these first.
    """

    DEADLINE = QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED
    INCOMPATIBLE = QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS
    LIVELINESS = QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED
    MATCHED = QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED

    def __init__(
        self, node: RclNode, msg_type: type[Message], full_name: str, qos: QoSProfile, raw: bool = False
    ) -> None:
        super().__init__(node, msg_type, full_name, qos, Policies.requested(qos))
        self.raw = raw
        self.messages = self._queue(qos._rosspin_kept, qos, _sent)  # and what the callback may ask about each
        self.nudge: Callable[[], None] = node.nudge  # tells the executor that waits
        self._received = 0
        self._transports: dict[Any, Transport] = {}  # by the publishers whose messages a fault of the run befalls
        self._early: dict[PublisherEndpoint, list[tuple[Message, int]] | None] = {}

    def begin(self) -> SubscriptionEndpoint:
        """Find the publishers, and be found. Return itself."""
        qos = self.qos_profile
        publishers = [entry.endpoint for entry in self.world.graph.subscribe(self.entry)]
        self.policies = Policies.requested(
            qos, [each.policies for each in publishers if isinstance(each, TopicEndpoint)]
        )
        self._deadline = self._countdown(self.DEADLINE, self.policies.deadline, again=True)
        self._leases: dict[Any, Countdown] = {}  # of the publishers that have been alive
        self._hears = self.policies.lease < FOR_EVER and self._handler(self.LIVELINESS) is not None
        for publisher in publishers:
            if self.is_remote(publisher):
                _discover(publisher, self)
            else:
                _connect(publisher, self, publisher, self)
        return self

    def receive(self, publisher: PublisherEndpoint, message: Message, sent: int) -> None:
        """Take a message that a publisher sends now (ns)."""
        if publisher not in self._early:
            self.deliver(publisher, message, sent)
        elif self.policies.reliable and (early := self._early[publisher]) is not None:
            early.append((message, sent))

    def expects(self, publisher: PublisherEndpoint) -> int:
        """Return when (ns) the last message of a publisher arrives that is under way and needs to be acknowledged."""
        transport = self._transports.get(publisher) if self.policies.reliable else None
        return transport.last if transport else 0

    def expect(self, publisher: PublisherEndpoint) -> None:
        """Expect a publisher of another process: until it is known here, reliable messages from it wait."""
        self._early[publisher] = []

    def meet(self, other: Any, policy: QoSPolicyKind | None) -> None:
        """See the base. What the publisher has kept comes a little later, with all that it published meanwhile."""
        super().meet(other, policy)
        if other in self.peers and self.policies.with_kept and other.policies.with_kept:
            self._early[other] = None
            self.world.at(self.world.clock.now() + KEPT, lambda: self._take_kept(other))
        else:
            for message, sent in self._early.pop(other) or ():
                self.deliver(other, message, sent)

    def _take_kept(self, publisher: PublisherEndpoint) -> None:
        del self._early[publisher]
        for message, sent in publisher.kept:
            self.deliver(publisher, message, sent)

    def hear(self, publisher: Any) -> None:
        """Note that a publisher is alive."""
        if not self._hears:
            return
        lease = self._leases.get(publisher)
        if lease is None:
            lease = self._leases[publisher] = Countdown(self.world, self._lease_of(publisher), self._miss)
            self.tell(self.LIVELINESS, alive=1)
        elif not lease.runs:
            self.tell(self.LIVELINESS, alive=1, not_alive=-1)
        lease.restart()

    def _lease_of(self, publisher: Any) -> int:
        """Return how long (ns) a publisher is alive: in another process as long as that, unless by hand."""
        return FOR_EVER if self.is_remote(publisher) and not publisher.policies.manual else self.policies.lease

    def _miss(self) -> None:
        self.tell(self.LIVELINESS, alive=-1, not_alive=1)

    def miss(self, publisher: Any) -> None:
        """Hear of a publisher no more, whose process was killed. It has said up to then that it is alive."""
        if publisher in self._leases and not publisher.policies.manual:
            lease = self._leases[publisher] = Countdown(self.world, self.policies.lease, self._miss)
            lease.restart()

    def join(self, other: Any) -> None:
        """See the base. A publisher of another process is alive immediately, unless by hand."""
        super().join(other)
        faults = self.world.graph.faults
        if faults and (self.is_remote(other) or not isinstance(other, Endpoint)):
            sender = other.node.full_name if isinstance(other, Endpoint) else TESTER
            receiver, reliable = self.node.full_name, self.policies.reliable
            if transport := faults.transport(self.entry.topic, sender, receiver, self.world, reliable):
                self._transports[other] = transport
                self.receive = self._receive_by_wire  # type: ignore[method-assign]
        if self._lease_of(other) == FOR_EVER:
            self.hear(other)

    def _receive_by_wire(self, publisher: Any, message: Message, sent: int) -> None:
        receive = partial(SubscriptionEndpoint.receive, self, publisher, message, sent)
        transport = self._transports.get(publisher)
        if transport is None or publisher in self._early:  # what is kept for it comes in its own way
            receive()
        else:
            transport.send(lambda: message, lambda: publisher in self.peers and receive())

    def part(self, other: Any) -> None:
        super().part(other)
        self._transports.pop(other, None)
        if lease := self._leases.pop(other, None):
            alive = int(lease.runs)
            self.tell(self.LIVELINESS, alive=-alive, not_alive=alive - 1)
            lease.stop()

    def deliver(self, publisher: Any, message: Message, sent: int) -> None:
        """Put a copy of a message, sent at a time (ns), into the queue."""
        for deadline in self._deadline:
            deadline.restart()
        self.hear(publisher)
        self._received += 1
        info = {
            "source_timestamp": sent,
            "received_timestamp": self.world.clock.system(),
            "publication_sequence_number": self._received,
            "reception_sequence_number": None,
        }
        try:
            self.messages.append((self._convert(message), info))
        except cdr.CDRError:
            return
        self.nudge()

    def _convert(self, message: Message | bytes) -> Message | bytes:
        """Make what the callback gets. Raises CDRError for bytes that hold no message."""
        if self.raw:
            return message if isinstance(message, bytes) else cdr.serialize(message)
        if isinstance(message, bytes):
            return cdr.deserialize(message, self.msg_type)
        return received(message, self.msg_type)

    def came_at(self, now: int) -> bool:
        """Whether the message that is the next to be taken has come at a time (ns)."""
        return bool(self.messages) and self.messages[0][1]["received_timestamp"] == now

    def take(self) -> tuple[Any, dict[str, Any]] | None:
        """Return the oldest message, and what should be known of it; None if there is none any more."""
        try:
            return None if self.is_destroyed else self.messages.popleft()
        except IndexError:
            return None


def _discover(publisher: PublisherEndpoint, subscription: SubscriptionEndpoint) -> None:
    """Let two endpoints in different processes find each other."""
    if publisher.entry.type == subscription.entry.type:
        policy = incompatible_policy(publisher.policies, subscription.policies)
        subscription.expect(publisher)
        publisher.introduce(subscription, policy)


def _connect(
    publisher: PublisherEndpoint, subscription: SubscriptionEndpoint, *by_age: PublisherEndpoint | SubscriptionEndpoint
) -> None:
    if publisher.entry.type != subscription.entry.type:
        return
    policy = incompatible_policy(publisher.policies, subscription.policies)
    if policy:
        for endpoint in by_age:
            if endpoint.node.context.ok():
                endpoint.refuse(policy)
        return
    publisher.join(subscription)
    subscription.join(publisher)
    if subscription.policies.with_kept:
        for message, sent in publisher.kept:
            subscription.deliver(publisher, message, sent)


def _sent(entry: tuple[Message, dict[str, Any]]) -> int:
    return entry[1]["source_timestamp"]  # type: ignore[no-any-return]


class _OnTopic(Entity):
    """What a publisher and a subscription have in common, as a node has them."""

    event_handlers: list[EventHandler]

    @property
    def topic_name(self) -> str:
        """The topic's full name."""
        self._rosspin.check()
        return str(self._rosspin.entry.topic)

    def destroy(self) -> None:
        """Leave the topic. A second call does nothing."""
        for handler in self.event_handlers:
            handler.destroy()
        self._rosspin.destroy()


class Publisher(_OnTopic):
    """Publishes messages on a topic. Made by ``Node.create_publisher``."""

    _rosspin: PublisherEndpoint
    _rosspin_held = "Publisher"

    def __init__(
        self,
        publisher_impl: PublisherEndpoint,
        msg_type: type[Message],
        topic: str,
        qos_profile: QoSProfile,
        event_callbacks: PublisherEventCallbacks,
        callback_group: CallbackGroup,
    ) -> None:
        super().__init__(publisher_impl)
        self.msg_type = msg_type
        self.topic = topic  # the name that the node gave
        self.qos_profile = qos_profile
        self._rosspin_handlers = event_callbacks.create_event_handlers(callback_group, publisher_impl, topic)
        self.event_handlers = self._rosspin_handlers
        publisher_impl.begin()

    def publish(self, msg: Message | bytes) -> None:
        """Publish a message, or the bytes of one, which are not checked.

        Raises TypeError for one of another class, AssertionError for one with wrong values, InvalidHandle if the
        publisher was destroyed, RCLError after shutdown.
        """
        endpoint = self._rosspin
        if endpoint.is_destroyed:
            endpoint.check()
        if not isinstance(msg, self.msg_type) and not isinstance(msg, bytes):
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")
        endpoint.publish(msg)

    def get_subscription_count(self) -> int:
        """How many subscriptions it sends to. Raises InvalidHandle if destroyed, RCLError after shutdown."""
        self._rosspin.check_context("failed to get subscription count")
        return len(self._rosspin.peers)

    def assert_liveliness(self) -> None:
        """Say that it is alive, which counts if its liveliness is ``MANUAL_BY_TOPIC``."""
        self._rosspin.check_context("Failed to assert liveliness on the Publisher")
        self._rosspin.assert_liveliness()

    def wait_for_all_acked(self, timeout: Any = None) -> bool:
        """Wait until what was published has arrived, which it has immediately unless a fault delays it.

        Return whether it has; ``timeout`` is a Duration, without limit if None or negative.
        """
        self._rosspin.check_context("Failed to wait for all acknowledgements")
        return self._rosspin.wait_for_all_acked(timeout)


class Subscription(_OnTopic):
    """Lets an executor call ``callback(message)``, or ``callback(message, info)``. Made by ``create_subscription``."""

    _rosspin_held = "Subscription"

    class CallbackType(Enum):
        """With what the callback is called."""

        MessageOnly = 0
        WithMessageInfo = 1

    _rosspin: SubscriptionEndpoint

    def __init__(
        self,
        subscription_impl: SubscriptionEndpoint,
        msg_type: type[Message],
        topic: str,
        callback: Callable[..., Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        raw: bool,
        event_callbacks: SubscriptionEventCallbacks,
    ) -> None:
        super().__init__(subscription_impl)
        self.msg_type = msg_type
        self.topic = topic  # the name that the node gave
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        self.qos_profile = qos_profile
        self.raw = raw
        self._rosspin_handlers = event_callbacks.create_event_handlers(callback_group, subscription_impl, topic)
        self.event_handlers = self._rosspin_handlers
        subscription_impl.begin()

    @property
    def callback(self) -> Callable[..., Any]:
        """What is called."""
        return self._callback

    @callback.setter
    def callback(self, value: Callable[..., Any]) -> None:
        self._callback = value
        for count, kind in enumerate(self.CallbackType, 1):
            try:
                inspect.signature(value).bind(*[None] * count)
            except TypeError:
                continue
            self._callback_type = kind
            self._rosspin_informs = count == 2
            return
        raise RuntimeError(
            "Subscription.__init__(): callback should be either be callable with one argument"
            "(to get only the message) or two (to get message and message info)"
        )

    def get_publisher_count(self) -> int:
        """How many publishers it receives from."""
        self._rosspin.check()
        return len(self._rosspin.peers)

    def _rosspin_take(self) -> Any:
        """Return the call to make, or None if there is no message any more."""
        taken = self._rosspin.take()
        return taken and (self._callback, taken if self._rosspin_informs else (taken[0],), None)


class _OutOfReach(ReentrantCallbackGroup):
    """A group from whose subscription no executor takes anything.

    On a real ROS an executor that spins the node races ``wait_for_message``, which here always wins.
    """

    def can_execute(self, entity: Any) -> bool:
        return False


def wait_for_message(
    msg_type: type[Message], node: Node, topic: str, *, qos_profile: QoSProfile | int = 1, time_to_wait: float = -1
) -> tuple[bool, Message | None]:
    """Subscribe to a topic and wait for a message, for at most ``time_to_wait`` seconds (negative: no limit).

    Return whether one came, and the message. A signal ends the wait; ``rclpy.shutdown()`` does not.
    """
    if not node.context.ok():
        raise invalid_context("initialize wait set")
    own, event = node.context._rosspin.state, Event()
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile, callback_group=_OutOfReach())
    endpoint = subscription._rosspin
    endpoint.nudge = event.set
    own.waiting[event] = None
    own.world.waiting = -1
    until = None if time_to_wait < 0 else time.monotonic_ns() + int(float(time_to_wait) * 1e9)
    try:
        while not endpoint.messages and node.context.ok():
            left = None if until is None else until - time.monotonic_ns()
            if left is not None and left <= 0:
                break
            event.wait(left)
        return (True, endpoint.messages.popleft()[0]) if endpoint.messages else (False, None)
    finally:
        del own.waiting[event]
        node.destroy_subscription(subscription)
