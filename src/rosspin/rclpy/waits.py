"""Who waits for what, without a limit, so that :mod:`rosspin.rclpy.deadlock` can say why nothing comes."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, Any, NamedTuple

from ..clocks.frames import Place, outwards, places, trail
from ..world.world import current
from .task import Task

if TYPE_CHECKING:
    from ..world.world import World

__all__ = ["Wait", "Waits", "waiting_for"]


class Wait(NamedTuple):
    """A thread, on ``stack``, that waits for ``goal``, a future or a Rate's timer.

    ``where()`` returns the task of an executor in which it does, or None, and the places of its stack.
    """

    goal: Any
    thread: str
    stack: object
    where: Callable[[], tuple[Task | None, list[Place]]]


class Waits:
    """The waits of a run. Its processes share them."""

    def __init__(self) -> None:
        self.current: list[Wait] = []


@contextmanager
def waiting_for(goal: Any, world: World) -> Iterator[None]:
    """Within this context the calling thread waits for a future, or for a Rate's timer."""
    waits = world.graph.part(Waits).current
    frame = sys._getframe(2)
    seen = _look(frame) if sys.platform == "emscripten" else None  # a page cannot look at a stack that is suspended
    wait = Wait(goal, threading.current_thread().name, current(), lambda: seen or _look(frame))
    waits.append(wait)
    try:
        yield
        if world.recording.watcher:
            world.recording.watcher.wakes(goal)
    finally:
        waits.remove(wait)


def _look(frame: FrameType) -> tuple[Task | None, list[Place]]:
    calls = (each for each in outwards(frame) if each.f_code is Task.__call__.__code__)
    found = next(calls, None)
    return found and found.f_locals["self"], places(trail(frame))
