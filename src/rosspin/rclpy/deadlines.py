"""Countdowns for deadlines, leases and lifespans: what comes too late, and what is too old (source: Fast DDS)."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from .qos import FOR_EVER

if TYPE_CHECKING:
    from ..clocks.clock import Clock
    from ..world.world import World

__all__ = ["Countdown", "Lasting"]


class Countdown:
    """Calls ``function`` when ``period`` (ns) has passed since the last :meth:`restart`.

    Once, or with ``again`` after each further period, too. Another ``period`` holds from the next restart on.
    """

    def __init__(self, world: World, period: int, function: Callable[[], object], again: bool = False) -> None:
        self._world = world
        self.period = period
        self._function = function
        self._again = again
        self._due: int | None = None
        self._looks = False  # whether it will look

    @property
    def runs(self) -> bool:
        """Whether it has begun, and is not over."""
        return self._due is not None

    def restart(self) -> None:
        """Begin again."""
        self._due = self._world.clock.now() + self.period
        self._look_later()

    def stop(self) -> None:
        """Call no more."""
        self._due = None

    def _look_later(self) -> None:
        if self._due is not None and self.period < FOR_EVER and not self._looks:
            self._looks = True
            self._world.at(self._due, self._look)

    def _look(self) -> None:
        self._looks = False
        if self._due is not None and self._due <= self._world.clock.now():
            self._due = self._due + self.period if self._again else None
            self._function()
        self._look_later()


class Lasting(deque[Any]):
    """Messages that last for a ``lifespan`` (ns); ``sent`` tells when (ns) one was sent."""

    def __init__(self, most: int | None, lifespan: int, clock: Clock, sent: Callable[[Any], int]) -> None:
        super().__init__(maxlen=most)
        self._lifespan = lifespan
        self._clock = clock
        self._sent = sent

    def _drop(self) -> None:
        oldest = self._clock.system() - self._lifespan
        while len(self) and self._sent(self[0]) <= oldest:
            super().popleft()

    def __bool__(self) -> bool:
        self._drop()
        return len(self) > 0

    def __iter__(self) -> Iterator[Any]:
        self._drop()
        return super().__iter__()

    def popleft(self) -> Any:
        """Return the oldest message that lasts. Raises IndexError if there is none."""
        self._drop()
        return super().popleft()
