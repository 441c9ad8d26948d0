"""What the nodes of one run share: its topics, who publishes and subscribes, and what is recorded of the run.

What is the same in every ROS. Who is told of whom, when two nodes connect, and what a queue keeps, is each ROS's own.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any, Generic, Protocol, TypeVar

from .clocks.clock import Clock

__all__ = ["End", "Graph", "Published", "Record", "Tester"]

Part = TypeVar("Part")


class End(Protocol):
    """A node's end of a topic: a publication or a subscription."""

    @property
    def topic(self) -> str:
        """The topic's full name."""

    @property
    def type(self) -> str:
        """The type of its messages, as in std_msgs/String."""


class Tester(Protocol):
    """A node that a test plays: it has an end of its own for each end that the others have."""

    def publication(self, subscription: Any) -> Any:
        """Its end for a subscription."""

    def subscription(self, publication: Any) -> Any:
        """Its end for a publication."""


E = TypeVar("E", bound=End)

# A tick as it is recorded: source, number, expected, real and duration in ns; the duration is None while it runs.
Record = list[Any]

# A message as it is recorded: topic, node, time (ns), and what makes the message when somebody asks for it.
Published = tuple[str, str, int, Callable[[], Any]]


class _Ends(Generic[E]):
    """Publications, or subscriptions, by topic; in the order in which they were made."""

    def __init__(self) -> None:
        self._of: dict[str, list[E]] = {}

    def add(self, end: E) -> None:
        self._of.setdefault(end.topic, []).append(end)

    def remove(self, end: E) -> None:
        ends = self._of.get(end.topic, [])
        if end in ends:
            ends.remove(end)

    def of(self, topic: str) -> list[E]:
        return list(self._of.get(topic, ()))

    def types(self) -> list[tuple[str, str]]:
        return [(topic, ends[0].type) for topic, ends in self._of.items() if ends]


class Graph:
    """What the nodes that run on one clock share.

    ``record`` says whether anybody asks for their ticks and messages, ``several`` whether the nodes are more than one.
    """

    def __init__(self, clock: Clock, record: bool, several: bool = False) -> None:
        self.several = several
        self.ticks: list[Record] | None = [] if record else None
        self.published: list[Published] | None = [] if record else None
        self.tester: Tester | None = None
        self._clock = clock
        self._parts: dict[type, Any] = {}
        self._lock = threading.Lock()
        self._publications: _Ends[Any] = _Ends()
        self._subscriptions: _Ends[Any] = _Ends()

    def part(self, kind: type[Part]) -> Part:
        """What one ROS keeps for all its nodes of this run: ``kind()``, made when it is first asked for."""
        if kind not in self._parts:
            self._parts[kind] = kind()
        return self._parts[kind]  # type: ignore[no-any-return]

    def advertise(self, publication: End) -> list[Any]:
        """Add a publication; the subscriptions that are there already."""
        found = self._add(publication, self._publications, self._subscriptions)
        return [*found, self.tester.subscription(publication)] if self.tester else found

    def subscribe(self, subscription: End) -> list[Any]:
        """Add a subscription; the publications that are there already."""
        found = self._add(subscription, self._subscriptions, self._publications)
        return [*found, self.tester.publication(subscription)] if self.tester else found

    def _add(self, end: End, same: _Ends[Any], other: _Ends[Any]) -> list[Any]:
        # In one go: of two ends that are made at the same time, exactly one finds the other.
        with self._lock:
            same.add(end)
            return other.of(end.topic)

    def remove(self, end: End) -> None:
        """Take an end away; one that is not there is no error."""
        with self._lock:
            self._publications.remove(end)
            self._subscriptions.remove(end)

    def topics(self) -> list[tuple[str, str]]:
        """The topics that somebody publishes, and their types."""
        with self._lock:
            return self._publications.types()

    def subscribed(self) -> list[tuple[str, str]]:
        """The topics to which somebody subscribes, and their types."""
        with self._lock:
            return self._subscriptions.types()

    def record(self, topic: str, node: str, make: Callable[[], Any]) -> None:
        """Keep that ``node`` has published, now, the message that ``make()`` gives."""
        if self.published is not None:
            self.published.append((topic, node, self._clock.now(), make))
