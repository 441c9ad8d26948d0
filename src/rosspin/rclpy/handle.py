"""The handles of nodes and of what they make (source: rclpy/src/rclpy/destroyable.cpp)."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

from ..world.world import NotSimulated
from .exceptions import InvalidHandle

__all__ = ["Handle", "Held"]


class Handle:
    """Stands for the C++ object behind a node, a timer and so on. A node can hold it: ``with timer.handle:``.

    ``check()`` raises InvalidHandle if the object was destroyed. All else that a handle has raises NotSimulated.
    """

    def __init__(self, check: Callable[[], None]) -> None:
        self._check = check

    def __enter__(self) -> None:
        self._check()

    def __exit__(self, *error: object) -> None:
        """Let it go."""

    def __getattr__(self, name: str) -> Any:
        raise NotSimulated(f"handle.{name}")


class Held:
    """Base of what a node makes and what has a handle."""

    _destroyed = False

    @cached_property
    def handle(self) -> Handle:
        """Its handle, which can be held and nothing else."""
        return Handle(self._check)

    def _check(self) -> None:
        if self._destroyed:
            raise InvalidHandle()
