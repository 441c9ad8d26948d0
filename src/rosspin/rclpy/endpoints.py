"""What the endpoints of topics and services have in common: each is a node's, and knows those it is joined to.

An endpoint is what rcl and the middleware keep of a publisher, a subscription, a client or a service. The object that a
node has holds it by :class:`Entity`, and the graph knows its entry alone.
"""

from __future__ import annotations

import itertools
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import ref

from .discovery import ENDPOINT, Participants, discovery_delay
from .duration import Held
from .exceptions import InvalidHandle
from .handle import Handle, Life
from .qos import QoSProfile

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..world.world import World
    from .handle import RclNode

__all__ = ["Endpoint", "Entity", "GraphEntry", "kind_of"]


class GraphEntry(NamedTuple):
    """An endpoint of a topic, or of a service, as the graph has it."""

    topic: str  # its full name
    type: str  # as in std_msgs/msg/String
    endpoint: Any


def kind_of(data_class: type) -> str:
    """Return the type for which a class stands, as in std_msgs/msg/String."""
    return f"{data_class.__module__.replace('.', '/').rpartition('/')[0]}/{data_class.__name__}"


class _Numbers:
    """How many endpoints of a run have a number. Its processes share them."""

    def __init__(self) -> None:
        self.numbers = itertools.count(1)


def _nobody() -> None:
    return None


class Endpoint:
    """Base of the endpoints. ``data_class`` is the class of what it carries."""

    def __init__(self, node: RclNode, data_class: type, full_name: str, qos: QoSProfile) -> None:
        self.node = node
        self.entry = GraphEntry(full_name, kind_of(data_class), self)
        self.qos_profile = qos
        self.peers: list[Any] = []
        self.made = node.context.state.clock.now()
        self.entity: Callable[[], Any] = _nobody  # what an executor calls for it
        self.is_destroyed = False
        node.endpoints.append(self)
        node.use()

    @property
    def world(self) -> World:
        """The world of its process."""
        return self.node.context.state.world

    @cached_property
    def rosspin_gid(self) -> bytes:
        """What tells it from all others of this run."""
        return next(self.world.graph.part(_Numbers).numbers).to_bytes(16, "little")

    def check(self) -> None:
        """Raise InvalidHandle if it was destroyed."""
        if self.is_destroyed:
            raise InvalidHandle()

    @property
    def is_gone(self) -> bool:
        """Whether it was destroyed, or its context has ended."""
        return self.is_destroyed or self.node.context.left is not None

    def is_remote(self, other: Any) -> bool:
        """Whether another endpoint is in another process, where it has to be found."""
        return isinstance(other, Endpoint) and other.world is not self.world

    def introduce(self, other: Any, *more: Any) -> None:
        """Let it and an endpoint in another process learn of each other, each by its ``meet(other, *more)``."""
        met = self.world.graph.part(Participants).met(self.node.context, other.node.context)
        delay = discovery_delay(self.node.full_name, other.node)
        both: tuple[Any, Any] = (self, other)
        for endpoint, another in (both, both[::-1]):
            endpoint.world.at(
                max(endpoint.made, another.made + ENDPOINT, met) + delay, partial(endpoint.meet, another, *more)
            )

    def withdraw(self) -> None:
        """Let no one find it any more."""
        raise NotImplementedError()

    def destroy(self) -> None:
        """Let the others learn that it is gone: immediately in this process, later in others. Twice is once."""
        # The collector may call this on any stack, and between any two lines of what follows.
        if self.is_destroyed or self.world.over:
            return
        self.is_destroyed = True
        self.withdraw()
        for peer in [*self.peers]:
            if peer.world is self.world:
                peer.part(self)
        self.be_missed(self.world.clock.now() + ENDPOINT)
        if self in self.node.endpoints:
            self.node.endpoints.remove(self)
        self.node.release()

    def be_missed(self, when: int) -> None:
        """Let the endpoints in other processes learn at ``when`` (ns) that it is gone."""
        for peer in [*self.peers]:
            if peer.world is not self.world:
                peer.world.at(when, partial(peer.part, self))

    def fall_silent(self) -> None:
        """Be alive no more: its process was killed."""

    def part(self, other: Any) -> None:
        """Learn that another endpoint is gone."""
        if other in self.peers:
            self.peers.remove(other)


class Entity(Held):
    """Base of publishers, subscriptions, clients and services, as a node has them.

    Names that rclpy's classes do not have begin with _rosspin, here and in all that a node can hold, so that they do
    not clash with what a node keeps there.
    """

    def __init__(self, endpoint: Any) -> None:
        self._rosspin = endpoint
        self._rosspin_life = Life(endpoint.destroy)
        endpoint.entity = ref(self)

    @property
    def handle(self) -> Handle:
        """Its handle, which can be held and nothing else."""
        return Handle(self._rosspin, self._rosspin_life)

    @property
    def logger_name(self) -> str:
        """The name of its node's logger."""
        self._rosspin.check()
        return str(self._rosspin.node.logger_name)

    def destroy(self) -> None:
        """Leave the topic, or the service. A second call does nothing."""
        self._rosspin.destroy()
