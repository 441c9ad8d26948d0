"""When roscpp's timer calls back: the rule by itself, for predictions about C++ nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

__all__ = ["Call", "timer_calls"]


class Call(NamedTuple):
    """One call of a timer's callback: when it was due and when it came (ns since the timer was made)."""

    expected: int
    real: int


def timer_calls(period: int, duration: Callable[[int], int], until: int) -> list[Call]:
    """The calls, up to the time ``until``, of the only timer of a roscpp node.

    ``period`` and ``until`` are in ns; ``duration(number)`` is how long call ``number``, from 1, takes (ns).

    A timer is armed anew only after its callback has returned. Its next call is due one period after the last one was;
    if even the call after that would have been due already, the next one is due now (source:
    ros/timer_manager.h, ``updateNext``).
    """
    calls: list[Call] = []
    due = now = period
    while (real := max(due, now)) <= until:
        calls.append(Call(due, real))
        now = real + duration(len(calls))
        due += period
        if due + period < now:
            due = now
    return calls
