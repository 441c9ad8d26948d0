"""Measuring by turns, and a line of the report."""

from __future__ import annotations

import gc
from collections.abc import Callable
from statistics import median

Times = dict[str, list[float]]


def by_turns(rounds: int, clock: Callable[[], float], functions: dict[str, Callable[[], object]]) -> Times:
    """The times that each function took, in the unit of ``clock``, one from each round.

    In a round each runs once, so that whatever else the machine does meets them all.
    """
    times: Times = {name: [] for name in functions}
    for _ in range(rounds):
        for name, function in functions.items():
            gc.collect()  # no one tidies up after the one before
            start = clock()
            function()
            times[name].append(clock() - start)
    return times


def ratio(times: Times, name: str, other: str) -> float:
    """The median over the rounds of what ``name`` took to what ``other`` took."""
    return median(one / another for one, another in zip(times[name], times[other]))


def line(what: str, value: float, *, most: float | None = None, least: float | None = None, times: str = "") -> str:
    """A line of the report: a ratio, the goal that it should not exceed or fall below, the times it is made of."""
    digits = 0 if value >= 1000 else 2 if value >= 0.1 else 7
    shown = round(value, digits)  # what is judged is what is read
    goal = ""
    if most is not None:
        goal = f"at most {most:,g}: {'holds' if shown <= most else 'MISSED'}"
    if least is not None:
        goal = f"at least {least:,g}: {'holds' if shown >= least else 'MISSED'}"
    number = f"{shown:,.{digits}f}" if digits < 7 else f"{shown:.2g}"
    return f"{what:<58} {number:>8}   {goal:<22} {f'({times})' if times else ''}".rstrip()
