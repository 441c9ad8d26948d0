"""What a clock is, and the one on the wall.

Times are integer nanoseconds, as in ROS: since the epoch on the wall, since the start of the run when simulated.
"""

from __future__ import annotations

import contextvars
import threading
import time
from collections.abc import Callable
from typing import Protocol

from .stacks import StackExit

__all__ = ["Clock", "Condition", "WallClock", "nanoseconds"]

NS = 1_000_000_000


def nanoseconds(seconds: float) -> int:
    """A length of time in integer nanoseconds.

    Raises, with the words of ``time.sleep``: ValueError for NaN, OverflowError for what no clock can hold, TypeError
    for what is not a number.
    """
    if isinstance(seconds, int):
        ns = seconds * NS
    else:
        if seconds != seconds:
            raise ValueError("Invalid value NaN (not a number)")
        if not isinstance(seconds, float):
            seconds = _number(seconds)
        ns = round(seconds * NS) if abs(seconds) < 2**63 else 2**63
    if not -(2**63) <= ns < 2**63:
        raise OverflowError("timestamp out of range for platform time_t")
    return ns


def _number(value: object) -> float:
    if hasattr(value, "__float__") or hasattr(value, "__index__"):
        return float(value)  # type: ignore[arg-type]
    raise TypeError(f"'{type(value).__name__}' object cannot be interpreted as an integer")


class Condition(Protocol):
    """Something to wait for on a clock."""

    def wait(self, ns: int) -> None:
        """Wait until the next ``notify_all``, at most ``ns`` nanoseconds."""

    def notify_all(self) -> None:
        """Let every waiter go on."""


class Clock(Protocol):
    """What the stand-in needs of time."""

    def now(self) -> int:
        """The time, in ns."""

    def sleep(self, ns: int) -> None:
        """Suspend the caller for ``ns`` nanoseconds; others run meanwhile. 0 or less only lets others run."""

    def start(self, function: Callable[[], None], name: str) -> None:
        """Run ``function`` concurrently, as a daemon: the run's end does not wait for it. ``name`` is for messages."""

    def condition(self) -> Condition:
        """A new condition on this clock."""


class WallClock:
    """Real time, a thread for each concurrent function, as in rospy."""

    def __init__(self) -> None:
        self._closed = False

    def now(self) -> int:
        return time.time_ns()

    def sleep(self, ns: int) -> None:
        if ns > 0:
            time.sleep(ns / NS)
        if self._closed and threading.current_thread().daemon:
            raise StackExit

    def start(self, function: Callable[[], None], name: str) -> None:
        context = contextvars.copy_context()

        def run() -> None:
            try:
                context.run(function)
            except StackExit:
                pass

        threading.Thread(target=run, name=name, daemon=True).start()

    def condition(self) -> Condition:
        return _WallCondition()

    def close(self) -> None:
        """End every thread that this clock started, at its next wake-up."""
        self._closed = True


class _WallCondition:
    def __init__(self) -> None:
        self._condition = threading.Condition()

    def wait(self, ns: int) -> None:
        with self._condition:
            self._condition.wait(ns / NS)

    def notify_all(self) -> None:
        with self._condition:
            self._condition.notify_all()
