"""While a simulation runs, the module ``time`` tells its stacks the simulation's time.

``process_time`` and ``thread_time`` are left alone, since they tell how much work was done. So is ``datetime``: its
classes cannot be replaced for stacks alone.
"""

from __future__ import annotations

import logging
import selectors
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .clock import NS, nanoseconds
from .loops import LoopSelector
from .patches import Patch, either, patched
from .stacks import Stack, current

__all__ = ["PATCHES", "virtual_time"]


_real_sleep = time.sleep


def _sleep(stack: Stack, seconds: float) -> None:
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    # ``subprocess`` waits for a process in real time, and naps between its looks at it.
    if sys._getframe(2).f_globals.get("__name__") == "subprocess":
        _real_sleep(seconds)
    else:
        stack.clock.sleep(nanoseconds(seconds))


def _seconds(stack: Stack) -> float:
    return stack.clock.seconds()


def _nanoseconds(stack: Stack) -> int:
    return stack.clock.now()


def _system_seconds(stack: Stack) -> float:
    return stack.clock.system() / NS


def _system_nanoseconds(stack: Stack) -> int:
    return stack.clock.system()


def _now_by_default(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap a function of ``time`` that takes seconds, by default now: on a stack, now is the simulation's."""

    def virtual(stack: Stack, seconds: float | None = None) -> Any:
        return real(_system_seconds(stack) if seconds is None else seconds)

    return either(virtual)(real)


def _local_by_default(real: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap a function of ``time`` that takes a date last, by default now: on a stack, now is the simulation's."""
    count = 1 if real is time.strftime else 0

    def virtual(stack: Stack, *args: Any) -> Any:
        return real(*args) if len(args) > count else real(*args, time.localtime(_system_seconds(stack)))

    return either(virtual)(real)


class _LoggingSince:
    """In place of ``logging._startTime``, which logging takes off the present: a simulated process begins at time 0."""

    def __init__(self, real: float) -> None:
        self._real = real

    def __rsub__(self, now: float) -> float:
        return now if isinstance(current(), Stack) else now - self._real


PATCHES: list[Patch] = [
    (logging, "_startTime", _LoggingSince),
    (time, "sleep", either(_sleep)),
    (selectors, "DefaultSelector", lambda real: LoopSelector),
    (time, "time", either(_system_seconds)),
    (time, "time_ns", either(_system_nanoseconds)),
    *((time, name, either(_seconds)) for name in ("monotonic", "perf_counter")),
    *((time, f"{name}_ns", either(_nanoseconds)) for name in ("monotonic", "perf_counter")),
    *((time, name, _now_by_default) for name in ("localtime", "gmtime", "ctime")),
    *((time, name, _local_by_default) for name in ("asctime", "strftime")),
]


@contextmanager
def virtual_time() -> Iterator[None]:
    """Within this context the stacks of simulations are told their simulation's time."""
    with patched(PATCHES):
        yield
