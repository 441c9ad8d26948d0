"""Suspend one Python call stack and continue with another in a web page, where there are no threads and no greenlet.

There Python is WebAssembly, whose call stacks the browser can suspend until a promise is kept (JSPI, JavaScript Promise
Integration). Each stack is a task of its own; all but one of them wait for a promise.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from contextvars import Context
from types import FrameType
from typing import Any

from js import Promise
from pyodide.ffi import run_sync

from .frames import Trail, trail

__all__ = ["Switched", "can_raise", "current", "settrace"]


class Switched:
    """Like :class:`rosspin.clocks.stacks.Switched`."""

    def __init__(self, function: Callable[[], Any], home: Switched | None) -> None:
        self.dead = False
        self._function = function
        self._home = home
        self.trail: Trail = []  # where it is suspended: its frames cannot be looked at then
        self._context = Context()
        self._started = False
        self._resume: Callable[[], None] | None = None
        self._error: BaseException | None = None

    def __bool__(self) -> bool:
        return self._started and not self.dead

    def switch(self) -> None:
        """Suspend the caller and continue with this stack."""
        _switch(self, None)

    def throw(self, error: BaseException | type[BaseException]) -> None:
        """Suspend the caller and raise ``error`` in this stack."""
        _switch(self, error() if isinstance(error, type) else error)

    async def _run_stack(self) -> None:
        error = None
        try:
            self._go_on_here()
            self._function()
        except BaseException as raised:
            error = raised
        self.dead = True
        assert self._home is not None
        self._home._go_on(error)

    def _go_on(self, error: BaseException | None) -> None:
        """Let this stack run as soon as the running one is suspended or ends."""
        global _running
        _running = self
        self._error = error
        if self._resume:
            self._resume()
        else:
            self._started = True
            asyncio.get_running_loop().create_task(self._run_stack(), context=self._context)

    def _go_on_here(self) -> None:
        if _trace:
            _trace("switch", (self, self))
        error, self._error = self._error, None
        if error is not None:
            raise error


# The stack that runs before any is made: the code that the page calls.
_running = Switched(lambda: None, None)
_running._started = True

Trace = Callable[[str, tuple["Switched", "Switched"]], None]

_trace: Trace | None = None


def settrace(trace: Trace | None) -> Trace | None:
    """Call ``trace("switch", (_, stack))`` on each stack that continues. Returns what was called until now."""
    global _trace
    before, _trace = _trace, trace
    return before


def _switch(stack: Switched, error: BaseException | None) -> None:
    if stack.dead:
        raise RuntimeError("this stack has ended")
    me = _running
    me.trail = trail(sys._getframe(1))
    turn = Promise.withResolvers()
    me._resume = turn.resolve
    stack._go_on(error)
    run_sync(turn.promise)
    me._resume = None
    me._go_on_here()


def current() -> Switched:
    """The stack that is running."""
    return _running


def can_raise(frame: FrameType | None) -> bool:
    """Whether an exception that is raised at ``frame`` ends the stack that runs there.

    Raised between two stacks, it would break the event loop, and with it all of Python.
    """
    codes = [code for code, _, _ in trail(frame)]
    return codes[-1:] == [Switched._run_stack.__code__] and _SWITCHING.isdisjoint(codes) and len(codes) > 1


_SWITCHING = {_switch.__code__, Switched._go_on.__code__}
