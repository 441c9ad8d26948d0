"""Compute when roscpp's timer calls back, by its rule alone, where no roscpp can run.

The rule is compared with recordings of the real one, and with the real one where ROS 1 is installed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from heapq import heappop, heappush
from itertools import count

from .ticks import Tick

__all__ = ["call_lengths", "timer_probe", "timer_ticks"]

_NS = 1_000_000_000


def timer_ticks(period: float, duration: Callable[[int], float], seconds: float, *, second: bool = False) -> list[Tick]:
    """Return the ticks of the only timer of a roscpp node in ``ros::spin``, up to ``seconds`` after it was made.

    ``period`` is the timer's (s); ``duration(number)`` is how long call ``number``, counted from 1, takes (s). With a
    ``second`` timer of the same period, made after it, its ticks are there as well. Its calls take no time, but wait
    until that of the first has returned, as one thread makes them all.

    A timer is armed again only after its callback has returned. Its next call is due one period after the last one was;
    if even the call after that would have been due already, the next one is due now (source:
    ros/timer_manager.h, ``updateNext``). A call that is due is put at the end of the queue.

    Raises ValueError for a period that is not above 0, with which roscpp would call back forever in no time.
    """
    if period <= 0:
        raise ValueError(f"with a period of {period:g}, roscpp calls back without a pause")
    ticks: list[Tick] = []
    step, until = round(period * _NS), round(seconds * _NS)
    arrival, now = count(), 0
    queue = [(step, next(arrival), source, 1, step) for source in ("timerCallback", "secondCallback")[: 1 + second]]
    while (real := max(queue[0][0], now)) <= until:
        _, _, source, number, due = heappop(queue)
        takes = 0 if source == "secondCallback" else round(duration(number) * _NS)
        now = real + takes
        took = takes / _NS if now <= until else math.nan
        ticks.append(Tick(source, number, due / _NS, real / _NS, took))
        due += step
        if due + step < now:
            due = now
        heappush(queue, (max(due, now), next(arrival), source, number + 1, due))
    return ticks


def timer_probe(seconds: float, args: Sequence[str]) -> list[Tick]:
    """Return the ticks of ``examples/timing_probes/src/timer_probe.cpp`` with these parameters, up to ``seconds``.

    Raises ValueError for a parameter that does not concern its timers, and for a period that is not above 0.
    """
    given = dict(word.removeprefix("_").split(":=", 1) for word in args)
    if unknown := given.keys() - {"period", "block", "block_call", "block_calls", "blocks", "second_timer"}:
        raise ValueError(f"the rule of roscpp's timer knows no {', '.join(sorted(unknown))}")
    second = given.get("second_timer", "").lower() == "true"
    return timer_ticks(float(given.get("period", 0.5)), call_lengths(given), seconds, second=second)


def call_lengths(given: Mapping[str, str]) -> Callable[[int], float]:
    """Return how long (s) each call of a probe takes, counted from 1, by the probe's parameters."""
    blocks = [float(length) for length in given.get("blocks", "").strip("[]").split(",") if length]
    block, first = float(given.get("block", 0)), int(given.get("block_call", 0))
    calls = int(given.get("block_calls", 1))

    def duration(number: int) -> float:
        if number <= len(blocks):
            return blocks[number - 1]
        return block if first == 0 or first <= number < first + calls else 0.0

    return duration
