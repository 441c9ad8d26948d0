"""What an executor waits for besides timers, topics and services (source: rclpy/waitable.py).

A node can make classes of these, but only a real executor can serve them: here it serves actions and events.
"""

from __future__ import annotations

from typing import Any

from .callback_groups import CallbackGroup

__all__ = ["NumberOfEntities", "Waitable"]


class NumberOfEntities:
    """How many things of each kind there are to wait for. Two can be added."""

    __slots__ = ["num_subscriptions", "num_guard_conditions", "num_timers", "num_clients", "num_services", "num_events"]

    def __init__(
        self,
        num_subs: int = 0,
        num_gcs: int = 0,
        num_timers: int = 0,
        num_clients: int = 0,
        num_services: int = 0,
        num_events: int = 0,
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        return type(self)(*(getattr(self, name) + getattr(other, name) for name in self.__slots__))

    def __repr__(self) -> str:
        return f"<{type(self).__name__}({', '.join(str(getattr(self, name)) for name in self.__slots__)})>"


class Waitable:
    """Base of what puts things into a wait set. Its methods raise NotImplementedError."""

    def __init__(self, callback_group: CallbackGroup) -> None:
        self.callback_group = callback_group
        callback_group.add_entity(self)
        self._executor_event = False
        self._futures: list[Any] = []

    def __enter__(self) -> None:
        """Keep it from being destroyed."""

    def __exit__(self, *error: object) -> None:
        """Let it be destroyed."""

    def add_future(self, future: Any) -> None:
        """Have callbacks of a future called."""
        self._futures.append(future)

    def remove_future(self, future: Any) -> None:
        """Call them no more."""
        self._futures.remove(future)

    def is_ready(self, wait_set: Any) -> bool:
        """Whether something in the wait set is ready."""
        raise NotImplementedError("Must be implemented by subclass")

    def take_data(self) -> Any:
        """Take what has come."""
        raise NotImplementedError("Must be implemented by subclass")

    async def execute(self, taken_data: Any) -> None:
        """Do something with it."""
        raise NotImplementedError("Must be implemented by subclass")

    def get_num_entities(self) -> NumberOfEntities:
        """How many things it waits for."""
        raise NotImplementedError("Must be implemented by subclass")

    def add_to_wait_set(self, wait_set: Any) -> None:
        """Put them into a wait set."""
        raise NotImplementedError("Must be implemented by subclass")
