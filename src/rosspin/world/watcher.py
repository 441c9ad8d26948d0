"""Who is told what a run does, step by step."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

__all__ = ["Watcher"]


class Watcher:
    """Is told what happens, on the thread that it happens on. This one is interested in nothing."""

    def says(self, words: str) -> None:
        """The thread does something, in words that continue its name."""

    def calls(self, entity: Any, executor: Any = None, late: int = 0) -> None:
        """A call begins, so late (ns): of a callback, or in ROS 2 of an entity or a task, by an executor."""

    def ends(self, entity: Any) -> None:
        """That call ends."""

    def asks(self, task: Any, callback: Any) -> None:
        """A function is handed to an executor, as a task."""

    def looks(self, executor: Any) -> None:
        """An executor begins to look for what is ready."""

    def finds(self, executor: Any, ready: Collection[Any]) -> None:
        """An executor has found what is ready."""

    def wakes(self, goal: Any) -> None:
        """The thread continues, since what it waited for is there."""

    def rings(self, ring: dict[str, Any]) -> None:
        """Some wait for each other: ``links`` are who waits for what, ``to`` is for whom the last of them waits."""
