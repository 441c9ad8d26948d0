"""Who waits for what, without a limit, so that :mod:`rosspin.rclpy.deadlock` can say why nothing comes."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from ..world.world import World

__all__ = ["Wait", "Waits", "waiting_for"]


class Wait(NamedTuple):
    """A thread that waits for ``goal``, a future or a Rate's timer. ``frame`` is where."""

    goal: Any
    thread: str
    frame: FrameType


class Waits:
    """The waits of a run. Its processes share them."""

    def __init__(self) -> None:
        self.current: list[Wait] = []


@contextmanager
def waiting_for(goal: Any, world: World) -> Iterator[None]:
    """Within this context the calling thread waits for a future, or for a Rate's timer."""
    waits = world.graph.part(Waits).current
    wait = Wait(goal, threading.current_thread().name, sys._getframe(2))
    waits.append(wait)
    try:
        yield
    finally:
        waits.remove(wait)
