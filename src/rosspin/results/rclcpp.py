"""Compute when rclcpp's timer calls back and when the passes of its Rate begin, by their rules alone.

The rules are compared with recordings of the real ones, and with the real ones where rclcpp is installed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path

from .roscpp import call_lengths
from .ticks import Tick

__all__ = ["probe", "rate_passes", "timer_ticks"]

_NS = 1_000_000_000


def timer_ticks(period: float, duration: Callable[[int], float], seconds: float) -> list[Tick]:
    """The ticks of the only timer of a node that spins, up to ``seconds`` after it was made.

    ``period`` is the timer's (s); ``duration(number)`` is how long call ``number``, counted from 1, takes (s).

    When a call begins, the next one is due one period after this one was. If that has passed, it is due at the next
    place on the grid (source: rcl/timer.c, ``rcl_timer_call``). So the rule is that of rclpy's timer.
    """
    step = round(period * _NS)
    due = step

    def next_call(real: int, now: int) -> tuple[int, int]:
        nonlocal due
        expected, due = due, due + step
        if due < real:
            due += (1 + (real - due - 1) // step) * step
        return expected, max(due, now)

    return _ticks("timerCallback", step, next_call, duration, seconds)


def rate_passes(period: float, duration: Callable[[int], float], seconds: float) -> list[Tick]:
    """The passes of a loop that sleeps on an ``rclcpp::Rate``, up to ``seconds`` after it was made.

    ``duration(number)`` is how long pass ``number``, counted from 1, works (s). A pass is expected on the grid of the
    first.

    ``sleep()`` ends one period after the mark, and moves the mark there. If that time has passed, it does not sleep;
    and if a whole period more has passed, the mark is set one period *ahead* of now (source: rclcpp/rate.cpp,
    ``Rate::sleep``). While now is before the mark, a full period follows each pass's work.
    """
    step = round(period * _NS)
    mark = expected = 0

    def next_pass(real: int, now: int) -> tuple[int, int]:
        nonlocal mark, expected
        before, expected = expected, expected + step
        due = now + step if now < mark else mark + step
        mark += step
        if due <= now:
            if now > due + step:
                mark = now + step
            due = now
        return before, due

    return _ticks("Rate", 0, next_pass, duration, seconds)


def _ticks(
    source: str,
    real: int,
    following: Callable[[int, int], tuple[int, int]],
    duration: Callable[[int], float],
    seconds: float,
) -> list[Tick]:
    """The ticks from ``real`` on (ns). Of one and of its end, ``following`` says when it was due and the next comes."""
    ticks: list[Tick] = []
    until = round(seconds * _NS)
    while real <= until:
        now = real + round(duration(len(ticks) + 1) * _NS)
        expected, coming = following(real, now)
        took = (now - real) / _NS if now <= until else math.nan
        ticks.append(Tick(source, len(ticks) + 1, expected / _NS, real / _NS, took))
        real = coming
    return ticks


_RULES = {"timer_probe": timer_ticks, "rate_probe": rate_passes}


def probe(file: str, seconds: float, args: Sequence[str]) -> list[Tick]:
    """The ticks of ``timer_probe.cpp`` or ``rate_probe.cpp`` in ``examples/ros2``, up to ``seconds``.

    Raises ValueError for a parameter that the rules do not know, and for a period that is not above 0.
    """
    given = dict(word.split(":=", 1) for word in args if word not in ("--ros-args", "-p"))
    if unknown := given.keys() - {"period", "block", "block_call", "blocks"}:
        raise ValueError(f"the rules of rclcpp know no {', '.join(sorted(unknown))}")
    period = float(given.get("period", 0.5))
    if period <= 0:
        raise ValueError(f"with a period of {period:g}, rclcpp calls back without a pause")
    return _RULES[Path(file).stem](period, call_lengths(given), seconds)
