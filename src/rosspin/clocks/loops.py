"""Loops of asyncio on a simulated clock: what a loop waits with, and which loop is the running one.

A loop takes its time from ``time.monotonic``, and waits in a selector for its next timer, for descriptors, or to be
woken by another thread. The selector here waits in simulated time as long as the loop has no descriptor but its own.
In a web page the loop is the browser's, and left alone.
"""

from __future__ import annotations

import math
import selectors
import signal
import sys
from collections.abc import Callable
from typing import Any

from .clock import nanoseconds
from .ending import heed
from .stacks import Stack, current

__all__ = ["LoopSelector", "Loops", "put_aside", "put_back"]

# What each round costs (ns) a loop that never waits: about as much as on a real machine. The first rounds are free: a
# loop with something to do also goes round without waiting.
_ROUND = 10_000
_FREE_ROUNDS = 1_000

_IN_PAGE = sys.platform == "emscripten"
_modules = sys.modules


class LoopSelector(selectors.DefaultSelector):
    """A selector that a loop of asyncio makes for itself on a stack; for all others it is the usual one."""

    def __init__(self) -> None:
        super().__init__()
        caller = sys._getframe(1)
        self._loop: Any = None
        if isinstance(current(), Stack) and caller.f_globals.get("__name__") == "asyncio.selector_events":
            self._take(caller.f_locals["self"])

    def _take(self, loop: Any) -> None:
        self._loop = loop
        self._waiting: Stack | None = None
        self._looked = -1  # when (ns) it last looked without waiting
        self._rounds = 0  # how often in a row it did so
        loop._write_to_self = self._wake
        loop._clock_resolution = max(loop._clock_resolution, 2 * math.ulp(loop.time()))  # after decades it is coarser
        loop.add_signal_handler = self._add_signal_handler

    def _add_signal_handler(self, number: int, callback: Callable[..., Any], *args: Any) -> None:
        """``loop.add_signal_handler``: the real one would be told by the operating system."""
        loop = self._loop
        loop._check_signal(number)
        loop._check_closed()
        loop._signal_handlers[number] = sys.modules["asyncio.events"].Handle(callback, args, loop, None)
        signal.signal(number, lambda *_: loop._handle_signal(number))

    def _wake(self) -> None:
        if self._waiting:
            self._waiting.clock.wake(self._waiting)

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        """Wait until a descriptor is ready, or until the loop is woken, for at most ``timeout`` seconds."""
        stack = current()
        if self._loop is None or not isinstance(stack, Stack):
            return super().select(timeout)
        heed()  # asyncio catches whatever a callback raises
        if timeout is not None and timeout <= 0:
            self._look(stack)
        if len(self.get_map()) > 1:
            return super().select(timeout)
        if timeout is None or timeout > 0:
            self._wait(stack, timeout)
        return []

    def _look(self, stack: Stack) -> None:
        """Take the time of a round of the loop, if it does nothing but go round."""
        now = stack.clock.now()
        self._rounds = self._rounds + 1 if now == self._looked else 1
        if self._rounds > _FREE_ROUNDS:
            stack.clock.sleep(_ROUND)
        self._looked = stack.clock.now()

    def _wait(self, stack: Stack, timeout: float | None) -> None:
        self._waiting = stack
        try:
            stack.clock.wait(None if timeout is None else nanoseconds(timeout))
        finally:
            self._waiting = None


# A loop that runs, and the task that runs in it.
Running = tuple[Any, Any]


def put_aside() -> Running | None:
    """Let no loop be the running one, so that another stack may run its own. Returns what ran, if anything did."""
    events: Any = _modules.get("asyncio.events")
    if events is None or _IN_PAGE or (loop := events._get_running_loop()) is None:
        return None
    task = _exchange_task(loop, None)
    events._set_running_loop(None)
    return loop, task


def put_back(running: Running | None) -> None:
    """Let the loop run again that was put aside."""
    if running:
        sys.modules["asyncio.events"]._set_running_loop(running[0])
        _exchange_task(*running)


def _exchange_task(loop: Any, new: Any) -> Any:
    """Make a task the running loop's. Python before 3.14 keeps one for each loop, not one for each thread."""
    return sys.modules["asyncio.tasks"]._swap_current_task(loop, new) if sys.version_info >= (3, 14) else None


class Loops:
    """A context in which no loop runs and none is set, as in a new process. The next time it is as code has left it."""

    def __init__(self) -> None:
        self._inside: tuple[Running | None, Any] = (None, None)

    def __enter__(self) -> None:
        self._outside = _exchange(self._inside)

    def __exit__(self, *_: object) -> None:
        self._inside = _exchange(self._outside)


def _exchange(new: tuple[Running | None, Any]) -> tuple[Running | None, Any]:
    """Make these what runs and the policy. Returns those that there were; None stands for none."""
    events: Any = sys.modules.get("asyncio.events")
    if events is None or _IN_PAGE:
        return None, None
    before = put_aside(), events._event_loop_policy
    put_back(new[0])
    events._event_loop_policy = new[1]
    return before
