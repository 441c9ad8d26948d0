"""Which callbacks may run at the same time (source: rclpy/callback_groups.py)."""

from __future__ import annotations

from typing import Any
from weakref import ref

__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"]


class CallbackGroup:
    """Base of the groups: what is in it is added when it is created."""

    def __init__(self) -> None:
        self.entities: set[ref[Any]] = set()

    def add_entity(self, entity: Any) -> None:
        """Put a timer, a subscription or a guard condition into the group."""
        self.entities.add(ref(entity))

    def has_entity(self, entity: Any) -> bool:
        """Whether it is in the group."""
        return ref(entity) in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Whether its callback might begin now."""
        raise NotImplementedError()

    def beginning_execution(self, entity: Any) -> bool:
        """Whether its callback may begin now; ``ending_execution`` follows if so."""
        raise NotImplementedError()

    def ending_execution(self, entity: Any) -> None:
        """Its callback has ended."""
        raise NotImplementedError()


class ReentrantCallbackGroup(CallbackGroup):
    """All at the same time, even one callback with itself."""

    def can_execute(self, entity: Any) -> bool:
        return True

    def beginning_execution(self, entity: Any) -> bool:
        return True

    def ending_execution(self, entity: Any) -> None:
        pass


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One at a time."""

    def __init__(self) -> None:
        super().__init__()
        self._turn = [None]  # taken by who runs: a list's pop() is atomic, and a lock's acquire() would cost more

    def can_execute(self, entity: Any) -> bool:
        return bool(self._turn)

    def beginning_execution(self, entity: Any) -> bool:
        try:
            self._turn.pop()
        except IndexError:
            return False
        return True

    def ending_execution(self, entity: Any) -> None:
        self._turn.append(None)
