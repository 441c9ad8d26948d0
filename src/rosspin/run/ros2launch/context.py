"""What a launch file's actions share while they run (source: launch/launch_context.py)."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import MutableMapping, Sequence
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .service import LaunchService

__all__ = ["LaunchContext"]


class LaunchContext:
    """The state of a launch: configurations, environment, event handlers, events. ``known`` is what is of an event."""

    def __init__(self, service: LaunchService, argv: Sequence[str]) -> None:
        self.service = service
        self.argv = list(argv)
        self.is_shutdown = False
        self.launch_configurations: dict[str, Any] = {}
        self.event_handlers: deque[Any] = deque()
        self.events: deque[Any] = deque()
        self.known: dict[str, Any] = {}
        self._stack: list[tuple[dict[str, Any], dict[str, str]]] = []

    @property
    def environment(self) -> MutableMapping[str, str]:
        """The environment of the processes to come."""
        return os.environ

    def push(self) -> None:
        """Begin a scope: what changes in configurations and environment lasts until its end."""
        self._stack.append((dict(self.launch_configurations), dict(os.environ)))

    def pop(self) -> None:
        """End a scope."""
        self.launch_configurations, environment = self._stack.pop()
        os.environ.clear()
        os.environ.update(environment)

    @property
    def locals(self) -> SimpleNamespace:
        """What is known while an event is handled, such as ``event``."""
        return SimpleNamespace(**self.known)

    def register_event_handler(self, event_handler: Any) -> None:
        """Let it handle events, before those that do already."""
        self.event_handlers.appendleft(event_handler)

    def emit_event_sync(self, event: Any) -> None:
        """Let an event be handled after those that wait already."""
        self.events.append(event)

    def perform_substitution(self, substitution: Any) -> str:
        """Return the text of a substitution."""
        return str(substitution.perform(self))
