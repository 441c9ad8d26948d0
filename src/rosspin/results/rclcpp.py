"""Compute when rclcpp's timer calls back and when the passes of its Rate begin, by their rules alone.

The rules are compared with recordings of the real ones, and with the real ones where rclcpp is installed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from .roscpp import call_lengths
from .ticks import Tick

__all__ = ["Timer", "rate_passes", "rate_probe", "timer_probe", "timer_ticks"]

_NS = 1_000_000_000


class Timer(NamedTuple):
    """A timer: the name of its callback, its period (s), and how long call ``number``, counted from 1, takes (s)."""

    source: str
    period: float
    duration: Callable[[int], float]


def timer_ticks(timers: Sequence[Timer], seconds: float) -> list[Tick]:
    """Return the ticks of timers whose calls one thread makes, up to ``seconds`` after they were made.

    When a call begins, the next one is due one period after this one was. If that has passed, it is due at the next
    place on the grid (source: rcl/timer.c, ``rcl_timer_call``). So the rule is that of rclpy's timer.

    The executor looks which timers are due, calls each of these, and looks again. Of two that are due, the one that was
    made last came first in all recordings: the executor goes through a hash table (source:
    rclcpp/executors/executor_entities_collection.hpp), which promises no order.
    """
    steps = {timer.source: round(timer.period * _NS) for timer in timers}
    due, now, until = dict(steps), 0, round(seconds * _NS)
    ticks: list[Tick] = []
    counts = dict.fromkeys(steps, 0)
    while (now := max(now, min(due.values()))) <= until:
        for source, _, duration in [timer for timer in reversed(timers) if due[timer.source] <= now]:
            if (real := now) > until:
                break
            counts[source] += 1
            now += round(duration(counts[source]) * _NS)
            took = (now - real) / _NS if now <= until else math.nan
            ticks.append(Tick(source, counts[source], due[source] / _NS, real / _NS, took))
            due[source] += steps[source]
            due[source] += max(0, -(-(real - due[source]) // steps[source])) * steps[source]
    return ticks


def rate_passes(period: float, duration: Callable[[int], float], seconds: float) -> list[Tick]:
    """Return the passes of a loop that sleeps on an ``rclcpp::Rate``, up to ``seconds`` after it was made.

    ``duration(number)`` is how long pass ``number``, counted from 1, works (s). A pass is expected on the grid of the
    first.

    ``sleep()`` ends one period after the mark, and moves the mark there. If that time has passed, it does not sleep;
    and if a whole period more has passed, the mark is set one period *ahead* of now (source: rclcpp/rate.cpp,
    ``Rate::sleep``). While now is before the mark, a full period follows each pass's work.
    """
    step, until = round(period * _NS), round(seconds * _NS)
    real = mark = expected = 0
    ticks: list[Tick] = []
    while real <= until:
        now = real + round(duration(len(ticks) + 1) * _NS)
        took = (now - real) / _NS if now <= until else math.nan
        ticks.append(Tick("Rate", len(ticks) + 1, expected / _NS, real / _NS, took))
        expected += step
        real = now + step if now < mark else mark + step
        mark += step
        if real <= now:
            if now > real + step:
                mark = now + step
            real = now
    return ticks


def timer_probe(seconds: float, args: Sequence[str]) -> list[Tick]:
    """Return the ticks of ``examples/ros2/timer_probe.cpp`` with this command line, up to ``seconds``.

    Raises ValueError for a parameter that the rule does not know, for a period that is not above 0, and where several
    threads make calls of one group.
    """
    given = _given(args, "second_timer", "second_period", "second_block", "executor", "group")
    timers = [Timer("timerCallback", _period(given), call_lengths(given))]
    if given.get("second_timer") == "true":
        second = float(given.get("second_block", 0))
        timers.append(Timer("secondCallback", _period(given, "second_period", timers[0].period), lambda number: second))
    if given.get("executor", "spin") == "spin":
        return timer_ticks(timers, seconds)
    if given.get("group") != "own":
        raise ValueError(
            "under several threads the rule of rclcpp's timer wants a group of its own for each: group:=own"
        )
    alone = [tick for timer in reversed(timers) for tick in timer_ticks([timer], seconds)]
    return sorted(alone, key=lambda tick: tick.real)


def rate_probe(seconds: float, args: Sequence[str]) -> list[Tick]:
    """Return the passes of ``examples/ros2/rate_probe.cpp`` with this command line, up to ``seconds``.

    Raises ValueError for a parameter that the rule does not know, and for a period that is not above 0.
    """
    given = _given(args)
    return rate_passes(_period(given), call_lengths(given), seconds)


def _given(args: Sequence[str], *known: str) -> dict[str, str]:
    given = dict(word.split(":=", 1) for word in args if word not in ("--ros-args", "-p"))
    if unknown := given.keys() - {"period", "block", "block_call", "blocks", *known}:
        raise ValueError(f"the rules of rclcpp know no {', '.join(sorted(unknown))}")
    return given


def _period(given: Mapping[str, str], name: str = "period", otherwise: float = 0.5) -> float:
    period = float(given.get(name, otherwise))
    if period <= 0:
        raise ValueError(f"with a period of {period:g}, rclcpp calls back without a pause")
    return period
