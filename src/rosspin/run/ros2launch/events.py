"""Events of a launch, and what can be done at them (sources: launch/events, launch/event_handlers)."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterable
from dataclasses import KW_ONLY, dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .context import LaunchContext

__all__ = [
    *(
        "Event",
        "EventHandler",
        "OnProcessExit",
        "OnProcessStart",
        "OnShutdown",
        "OnTimer",
        "ProcessExited",
        "ProcessStarted",
    ),
    *("Shutdown", "ShutdownProcess", "SignalProcess", "TimerEvent", "matches_action"),
]


class Event:
    """Something that has happened."""


@dataclass(eq=False)
class Shutdown(Event):
    _: KW_ONLY
    reason: str = "reason not given"
    due_to_sigint: bool = False


@dataclass(eq=False)
class TimerEvent(Event):
    _: KW_ONLY
    timer_action: Any
    locals: dict[str, Any] = field(default_factory=dict)  # of the moment at which the timer was started


@dataclass(eq=False)
class ProcessStarted(Event):
    _: KW_ONLY
    action: Any
    process_name: str
    cmd: list[str]


@dataclass(eq=False)
class ProcessExited(ProcessStarted):
    _: KW_ONLY
    returncode: int


@dataclass(eq=False)
class ShutdownProcess(Event):
    _: KW_ONLY
    process_matcher: Callable[[Any], bool]


@dataclass(eq=False)
class SignalProcess(ShutdownProcess):
    _: KW_ONLY
    signal_number: signal.Signals | str

    @property
    def signal(self) -> signal.Signals:
        number = self.signal_number
        return signal.Signals[number] if isinstance(number, str) else signal.Signals(number)


def matches_action(target_action: Any) -> Callable[[Any], bool]:
    """Match the process of one action."""
    return lambda action: action is target_action


@dataclass(eq=False)
class EventHandler:
    """What should be done at an event that ``matcher`` accepts: actions, or a function that returns some."""

    _: KW_ONLY
    matcher: Callable[[Any], bool]
    entities: Any = None
    handle_once: bool = False

    def matches(self, event: Any) -> bool:
        return self.matcher(event)

    def handle(self, event: Any, context: LaunchContext) -> Iterable[Any]:
        """Return what should be done next."""
        context.known.update({"event": event})
        if self.handle_once:
            context.event_handlers.remove(self)
        found = self.entities(event, context) if callable(self.entities) else self.entities
        return [each for each in (found if isinstance(found, Iterable) else [found]) if each is not None]


class _OnProcess(EventHandler):
    kind: type[Any] = ProcessStarted

    def __init__(self, target_action: Any, do: Any, handle_once: bool) -> None:
        def matches(event: Any) -> bool:
            if type(event) is not self.kind:
                return False
            if target_action is None or event.action is target_action:
                return True
            return callable(target_action) and bool(target_action(event.action))

        super().__init__(matcher=matches, entities=do, handle_once=handle_once)


class OnProcessStart(_OnProcess):
    def __init__(self, *, target_action: Any = None, on_start: Any, handle_once: bool = False) -> None:
        super().__init__(target_action, on_start, handle_once)


class OnProcessExit(_OnProcess):
    kind = ProcessExited

    def __init__(self, *, target_action: Any = None, on_exit: Any, handle_once: bool = False) -> None:
        super().__init__(target_action, on_exit, handle_once)


class OnTimer(EventHandler):
    """Does what a timer defers, with what was known when the timer was started."""

    def __init__(self) -> None:
        super().__init__(matcher=lambda event: isinstance(event, TimerEvent), entities=self._fire)

    def _fire(self, event: TimerEvent, context: LaunchContext) -> Any:
        context.known.update(event.locals)
        return event.timer_action.actions


class OnShutdown(EventHandler):
    def __init__(self, *, on_shutdown: Any, handle_once: bool = False) -> None:
        super().__init__(
            matcher=lambda event: isinstance(event, Shutdown), entities=on_shutdown, handle_once=handle_once
        )
