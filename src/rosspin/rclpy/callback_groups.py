"""Which callbacks may run at the same time (source: rclpy/callback_groups.py)."""

from __future__ import annotations

from _thread import allocate_lock
from typing import Any
from weakref import ref

__all__ = ["CallbackGroup", "MutuallyExclusiveCallbackGroup", "ReentrantCallbackGroup"]


class CallbackGroup:
    """Base of the groups. What has a callback, such as a timer or a service, joins its group when it is created."""

    def __init__(self) -> None:
        self.entities: set[ref[Any]] = set()

    def add_entity(self, entity: Any) -> None:
        """Put what has a callback into the group."""
        self.entities.add(ref(entity))

    def has_entity(self, entity: Any) -> bool:
        """Whether what has a callback is in the group."""
        return ref(entity) in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Whether its callback could begin now."""
        raise NotImplementedError()

    def beginning_execution(self, entity: Any) -> bool:
        """Begin its callback if possible, and return whether it begins. If so, ``ending_execution`` follows."""
        raise NotImplementedError()

    def ending_execution(self, entity: Any) -> None:
        """Note that its callback has ended."""
        raise NotImplementedError()


class ReentrantCallbackGroup(CallbackGroup):
    """Lets all callbacks run at the same time, even two calls of one callback."""

    def can_execute(self, entity: Any) -> bool:
        return True

    def beginning_execution(self, entity: Any) -> bool:
        return True

    def ending_execution(self, entity: Any) -> None:
        pass


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """Lets one callback run at a time."""

    def __init__(self) -> None:
        super().__init__()
        self._lock = allocate_lock()  # as in rclpy, where no copy is made of what has one
        # Taken by the callback that runs: a list's pop() is atomic, and cheaper than a lock.
        self._rosspin_turn = [None]

    def can_execute(self, entity: Any) -> bool:
        return bool(self._rosspin_turn)

    def beginning_execution(self, entity: Any) -> bool:
        try:
            self._rosspin_turn.pop()
        except IndexError:
            return False
        return True

    def ending_execution(self, entity: Any) -> None:
        self._rosspin_turn.append(None)
