"""Publishers and subscriptions (sources: rclpy/publisher.py, rclpy/subscription.py, rclpy/wait_for_message.py).

On a real ROS a middleware carries the messages. Here a publisher puts copies of them into the subscriptions' queues.
The ends in one process find each other at once; :mod:`rosspin.rclpy.discovery` says how others do.
"""

from __future__ import annotations

import inspect
import time
from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..messages.ros2 import Message, transfer
from .callback_groups import ReentrantCallbackGroup
from .discovery import KEPT, discover
from .ends import Owner
from .exceptions import RCLError
from .qos import Policies, QoSProfile, incompatible_policy
from .state import Gate

if TYPE_CHECKING:
    from .node import Node

__all__ = ["Publisher", "Subscription", "wait_for_message"]


class TopicEnd(Owner):
    """What a publisher and a subscription have in common."""

    def __init__(
        self,
        node: Node,
        msg_type: type[Message],
        topic: str,
        full_name: str,
        qos: QoSProfile,
        policies: Policies,
    ) -> None:
        super().__init__(node, msg_type, full_name, qos)
        self.msg_type = msg_type
        self.topic = topic  # the name that the node gave
        self.policies = policies

    @property
    def topic_name(self) -> str:
        """The topic's full name."""
        self._check()
        return self.end.topic

    def refuse(self, policy: str) -> None:
        """Let the node warn, when it spins, by which policy another end does not match."""
        text = self._refusal.format(self.topic, policy)
        self.node.create_guard_condition(lambda: self.node.get_logger().warning(text)).trigger()

    _refusal: str

    def destroy(self) -> None:
        """Leave the topic."""
        self._check()
        self._leave()

    def withdraw(self) -> None:
        """See the base."""
        self.world.graph.remove(self.end)

    def is_remote(self, other: Any) -> bool:
        """Whether another end is in another process, where it has to be found."""
        return isinstance(other, Owner) and other.world is not self.world

    def meet(self, other: Any, policy: str | None) -> None:
        """Learn of an end in another process. ``policy`` is the one by which the two do not match, or None."""
        if self.is_gone or other.is_gone:
            return
        if policy:
            self.refuse(policy)
        else:
            self.peers.append(other)


class Publisher(TopicEnd):
    """Publishes messages on a topic. Made by ``Node.create_publisher``."""

    _refusal = (
        "New subscription discovered on topic '{}', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: {}"
    )

    def __init__(self, node: Node, msg_type: type[Message], topic: str, full_name: str, qos: QoSProfile) -> None:
        super().__init__(node, msg_type, topic, full_name, qos, Policies.offered(qos))
        self.kept: deque[Message] = deque(maxlen=qos.kept if self.policies.transient_local else 0)
        for end in self.world.graph.advertise(self.end):
            if self.is_remote(end.owner):
                discover(self, end.owner)
            else:
                _connect(self, end.owner, end.owner, self)

    def publish(self, msg: Message) -> None:
        """Publish a message. Raises TypeError for one of another class, AssertionError for one with wrong values.

        Raises InvalidHandle if the publisher was destroyed, RCLError after shutdown.
        """
        self._check()
        if not isinstance(msg, self.msg_type):
            raise TypeError(f"Expected {self.msg_type}, got {type(msg)}")
        if not self.node.context.ok():
            raise RCLError("Failed to publish: publisher's context is invalid")
        message = transfer(msg, self.msg_type)
        self.kept.append(message)
        recording = self.world.recording
        if recording.published is not None:
            recording.add_message(self.end.topic, self.node.get_fully_qualified_name(), lambda: message)
        for subscription in list(self.peers):
            subscription.receive(self, message)

    def get_subscription_count(self) -> int:
        """How many subscriptions it sends to."""
        self._check()
        return len(self.peers)

    def assert_liveliness(self) -> None:
        """Do nothing: liveliness is not watched here."""
        self._check()

    def wait_for_all_acked(self, timeout: Any = None) -> bool:
        """Return True: what was published has arrived."""
        self._check()
        return True


class Subscription(TopicEnd):
    """Lets an executor call ``callback(message)``, or ``callback(message, info)``. Made by ``create_subscription``.

    It keeps the newest messages, as many as its QoS says, and hands out the oldest of these first.
    """

    _refusal = (
        "New publisher discovered on topic '{}', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: {}"
    )

    def __init__(
        self,
        node: Node,
        msg_type: type[Message],
        topic: str,
        full_name: str,
        callback: Callable[..., Any],
        callback_group: Any,
        qos: QoSProfile,
    ) -> None:
        super().__init__(node, msg_type, topic, full_name, qos, Policies.requested(qos))
        self.callback = callback
        self.callback_group = callback_group
        self.messages: deque[tuple[Message, dict[str, Any]]] = deque(maxlen=qos.kept)
        self.nudge: Callable[[], None] | None = None  # tells the executor that waits
        self._executor_event = False
        self._received = 0
        self._early: dict[Publisher, list[tuple[Message, int]] | None] = {}
        publishers = [end.owner for end in self.world.graph.subscribe(self.end)]
        self.policies = Policies.requested(qos, [publisher.policies for publisher in publishers])
        for publisher in publishers:
            if self.is_remote(publisher):
                discover(publisher, self)
            else:
                _connect(publisher, self, publisher, self)

    @property
    def callback(self) -> Callable[..., Any]:
        """What is called."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any]) -> None:
        for count in (1, 2):
            try:
                inspect.signature(callback).bind(*[None] * count)
            except TypeError:
                continue
            self._callback, self._wants_info = callback, count == 2
            return
        raise RuntimeError(
            "Subscription.__init__(): callback should be either be callable with one argument"
            "(to get only the message) or two (to get message and message info)"
        )

    def receive(self, publisher: Publisher, message: Message) -> None:
        """Take a message that a publisher sends now."""
        if publisher not in self._early:
            self.deliver(message, self.world.clock.now())
        elif self.policies.reliable and (early := self._early[publisher]) is not None:
            early.append((message, self.world.clock.now()))

    def expect(self, publisher: Publisher) -> None:
        """Expect a publisher of another process: until it is known here, reliable messages from it wait."""
        self._early[publisher] = []

    def meet(self, other: Any, policy: str | None) -> None:
        """See the base. What the publisher has kept comes a little later, with all that it published meanwhile."""
        super().meet(other, policy)
        if other in self.peers and self.policies == other.policies == (True, True):
            self._early[other] = None
            self.world.at(self.world.clock.now() + KEPT, lambda: self._take_kept(other))
        else:
            for message, sent in self._early.pop(other) or ():
                self.deliver(message, sent)

    def _take_kept(self, publisher: Publisher) -> None:
        del self._early[publisher]
        for message in publisher.kept:
            self.deliver(message, self.world.clock.now())

    def deliver(self, message: Message, sent: int) -> None:
        """Put a copy of a message into the queue."""
        self._received += 1
        info = {
            "source_timestamp": sent,
            "received_timestamp": self.world.clock.now(),
            "publication_sequence_number": self._received,
            "reception_sequence_number": None,
        }
        self.messages.append((transfer(message, self.msg_type), info))
        if self.nudge:
            self.nudge()

    def take(self) -> Any:
        """Return the call to make, or None if there is no message any more."""
        if self._destroyed:
            return None
        try:
            message, info = self.messages.popleft()
        except IndexError:
            return None
        return self._callback, (message, info) if self._wants_info else (message,), None

    def get_publisher_count(self) -> int:
        """How many publishers it receives from."""
        self._check()
        return len(self.peers)


def _connect(publisher: Publisher, subscription: Subscription, *by_age: Publisher | Subscription) -> None:
    if publisher.end.type != subscription.end.type:
        return
    policy = incompatible_policy(publisher.policies, subscription.policies)
    if policy:
        for owner in by_age:
            if owner.node.context.ok():
                owner.refuse(policy)
        return
    publisher.peers.append(subscription)
    subscription.peers.append(publisher)
    if subscription.policies == (True, True):
        for message in publisher.kept:
            subscription.deliver(message, publisher.world.clock.now())


class _OutOfReach(ReentrantCallbackGroup):
    """A group from whose subscription no executor takes anything.

    On a real ROS an executor that spins the node races ``wait_for_message``, which here always wins.
    """

    def can_execute(self, entity: Any) -> bool:
        return False


def wait_for_message(
    msg_type: type[Message], node: Node, topic: str, *, qos_profile: QoSProfile | int = 1, time_to_wait: float = -1
) -> tuple[bool, Message | None]:
    """Subscribe to a topic and wait for a message, for at most ``time_to_wait`` seconds (negative: for ever).

    Return whether one came, and the message. A signal ends the wait; ``rclpy.shutdown()`` does not.
    """
    own, gate = node.context.state, Gate()
    subscription = node.create_subscription(msg_type, topic, lambda _: None, qos_profile, callback_group=_OutOfReach())
    subscription.nudge = gate.open
    own.waiting[gate] = None
    until = None if time_to_wait < 0 else time.monotonic_ns() + int(float(time_to_wait) * 1e9)
    valid = node.context.ok()
    try:
        while not subscription.messages and node.context.ok() == valid:
            left = None if until is None else until - time.monotonic_ns()
            if left is not None and left <= 0:
                break
            gate.wait(left)
        return (True, subscription.messages.popleft()[0]) if subscription.messages else (False, None)
    finally:
        del own.waiting[gate]
        node.destroy_subscription(subscription)
