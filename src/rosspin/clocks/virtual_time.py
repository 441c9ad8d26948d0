"""While a simulation runs, ``time`` and ``datetime`` tell its stacks the simulation's time.

What tells how much work was done (``process_time``, ``thread_time``) is left alone.
"""

from __future__ import annotations

import datetime
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .clock import nanoseconds
from .patches import Patch, either, patched
from .stacks import Stack, current

__all__ = ["virtual_time"]


def _sleep(stack: Stack, seconds: float) -> None:
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    stack.clock.sleep(nanoseconds(seconds))


def _seconds(stack: Stack) -> float:
    return stack.clock.seconds()


def _nanoseconds(stack: Stack) -> int:
    return stack.clock.now()


def _now_by_default(real: Callable[..., Any]) -> Callable[..., Any]:
    """A function of ``time`` that takes seconds, or now: now is the simulation's."""

    def virtual(stack: Stack, seconds: float | None = None) -> Any:
        return real(stack.clock.seconds() if seconds is None else seconds)

    return either(virtual)(real)


def _local_by_default(real: Callable[..., Any]) -> Callable[..., Any]:
    """A function of ``time`` whose last argument is a date, or now: now is the simulation's."""
    count = 1 if real is time.strftime else 0

    def virtual(stack: Stack, *args: Any) -> Any:
        return real(*args) if len(args) > count else real(*args, time.localtime(stack.clock.seconds()))

    return either(virtual)(real)


class _AsReal(type):
    """What is made by the classes below is of the real class, whoever asks."""

    def __instancecheck__(cls, value: object) -> bool:
        return isinstance(value, cls.__base__ or object)

    def __subclasscheck__(cls, other: type) -> bool:
        return issubclass(other, cls.__base__ or object)


def _date(real: Any) -> Any:
    def today(cls: type) -> Any:
        stack = current()
        return real.fromtimestamp(stack.clock.seconds()) if isinstance(stack, Stack) else real.today()

    return _AsReal(real.__name__, (real,), {"__new__": lambda cls, *a, **k: real(*a, **k), "today": classmethod(today)})


def _datetime(real: Any) -> Any:
    def now(cls: type, tz: datetime.tzinfo | None = None) -> Any:
        stack = current()
        return real.fromtimestamp(stack.clock.seconds(), tz) if isinstance(stack, Stack) else real.now(tz)

    def utcnow(cls: type) -> Any:
        return now(cls, datetime.UTC).replace(tzinfo=None)

    replaced = _date(real)
    replaced.now, replaced.utcnow = classmethod(now), classmethod(utcnow)
    return replaced


_PATCHES: list[Patch] = [
    (time, "sleep", either(_sleep)),
    *((time, name, either(_seconds)) for name in ("time", "monotonic", "perf_counter")),
    *((time, f"{name}_ns", either(_nanoseconds)) for name in ("time", "monotonic", "perf_counter")),
    *((time, name, _now_by_default) for name in ("localtime", "gmtime", "ctime")),
    *((time, name, _local_by_default) for name in ("asctime", "strftime")),
    (datetime, "date", _date),
    (datetime, "datetime", _datetime),
]


@contextmanager
def virtual_time() -> Iterator[None]:
    """Within this context the stacks of simulations are told their simulation's time."""
    with patched(_PATCHES):
        yield
