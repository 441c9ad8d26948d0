"""Figures of merit of ticks: periods, lateness, jitter, in numbers and in words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from statistics import median

from .ticks import Tick

__all__ = [
    "by_source",
    "describe_lateness",
    "describe_periods",
    "describe_timeline",
    "lost",
    "periods",
    "quantile",
    "say_time",
]

# Fewer have no hundredth part to speak of.
_MANY = 100


def by_source(ticks: Sequence[Tick]) -> dict[str, list[Tick]]:
    """The ticks of each source, in the order in which the sources ticked first."""
    groups: dict[str, list[Tick]] = {}
    for tick in ticks:
        groups.setdefault(tick.source, []).append(tick)
    return groups


def periods(ticks: Sequence[Tick]) -> list[float]:
    """The times from each tick to the next, in seconds; the ticks are of one source."""
    return [later.real - earlier.real for earlier, later in pairwise(ticks)]


def lost(ticks: Sequence[Tick], period: float) -> list[float]:
    """The times (s) that a timer or a rate skipped, on the grid of ``period`` seconds through the first expected tick.

    A tick stands for the last time on the grid that is not after the one at which it was expected; a time that no tick
    stands for, though a later one has its tick, is lost. The ticks are of one source.
    """
    if not ticks:
        return []
    origin = previous = ticks[0].expected
    moved = 0.0
    served = []
    for tick in ticks:
        if tick.expected - previous > 1.5 * period:  # roscpp and rclpy move ``expected`` to the new grid
            moved = 0.0
        due = tick.expected + moved
        served.append(int((due - origin) / period + 1e-3))
        if tick.real - due > 2 * period:  # rospy leaves it as it was: see ``rospy.Rate.sleep``
            moved = tick.real - tick.expected
        previous = tick.expected
    return [origin + number * period for number in sorted({*range(served[-1])} - {*served})]


def quantile(values: Sequence[float], share: float) -> float:
    """The smallest of the values that is no less than ``share`` of them, from 0 for the least to 1 for the greatest.

    ``share`` counts as it is written in decimals: 0.07 of a hundred values are seven of them, although the float is a
    little more. No values, or another share: ValueError.
    """
    if not values:
        raise ValueError("no values")
    if not 0 <= share <= 1:
        raise ValueError(f"a share is from 0 to 1, not {share!r}")
    count = math.ceil(Fraction(str(share)) * len(values))
    return sorted(values)[max(count, 1) - 1]


def say_time(seconds: float) -> str:
    """A length of time in the unit that suits it: ``0.5 s``, ``1.3 ms``, ``85 µs``."""
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if abs(seconds) >= 0.0995 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e6:.3g} µs" if abs(seconds) >= 0.5e-9 else "0"


def describe_timeline(name: str, group: Sequence[Tick]) -> str:
    """The ticks of one source in a sentence or two: how many, from when to when, and how late."""
    if not group:
        return f"{name}: no tick."
    span = f"{len(group)} ticks from {group[0].real:.3f} s to {group[-1].real:.3f} s"
    if len(group) == 1:
        span = f"1 tick at {group[0].real:.3f} s"
    return f"{name}: {span}. {describe_lateness(group)}"


def describe_lateness(ticks: Sequence[Tick]) -> str:
    """The lateness of ticks in a sentence."""
    if not ticks:
        return "There was no tick."
    late = [tick.lateness for tick in ticks]
    if max(map(abs, late)) < 0.5e-6:
        return f"All of {_count(late)} came when expected."
    if median(late) < 0.5e-6:
        return f"Of {_count(late)}, at least half came when expected; the latest was {say_time(max(late))} late."
    most = f"99 % at most {say_time(quantile(late, 0.99))}, " if len(late) >= _MANY else ""
    return (
        f"Of {_count(late)}, half were at most {say_time(median(late))} late, {most}the latest {say_time(max(late))}."
    )


def describe_periods(ticks: Sequence[Tick]) -> str:
    """The periods between ticks of one source in a sentence: their median and how far they spread.

    Of many, the hundredth part at either end is left out.
    """
    times = periods(ticks)
    if not times:
        return "There was no second tick, so there is no period."
    middle, low, high = median(times), quantile(times, 0.01), quantile(times, 0.99)
    if max(times) - min(times) < 1e-6:
        return f"Every period was {say_time(middle)}: no jitter."
    share = f"98 % of {len(times)}" if len(times) >= _MANY else f"all {len(times)}"
    return (
        f"The median period was {middle * 1e3:.3f} ms; {share} periods lay between "
        f"{low * 1e3:.3f} ms and {high * 1e3:.3f} ms, a jitter of {say_time(high - low)}."
    )


def _count(values: Sequence[object]) -> str:
    return "1 tick" if len(values) == 1 else f"{len(values)} ticks"
