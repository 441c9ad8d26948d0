"""What random graphs of publishers and subscribers are made of."""

from __future__ import annotations

from typing import NamedTuple


class Source(NamedTuple):
    """A publisher: its topic, when it is made, publishes first, and how often (ms); whether it latches."""

    topic: str
    made: int
    first: int
    period: int
    latch: bool


class Sink(NamedTuple):
    """A subscriber: its topic, when it is made, how long its callback takes (ms), its queue_size."""

    topic: str
    made: int
    takes: int
    queue_size: int | None


LENGTH = 6_000
