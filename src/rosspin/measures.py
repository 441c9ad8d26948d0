"""Measure ticks, and messages as ticks: their periods, lateness and jitter, as numbers and in words."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from statistics import median

from .results.ticks import FaultEvent, Message, Tick

__all__ = [
    "by_source",
    "describe_faults",
    "describe_lateness",
    "describe_pace",
    "describe_periods",
    "describe_timeline",
    "lost",
    "lost_by_source",
    "periods",
    "quantile",
    "rostopic_hz",
    "say_time",
    "side_by_side",
    "topic_ticks",
    "verdict",
]

# Fewer values have no hundredth part to speak of.
_MANY = 100

# A difference below this part of a period does not count: on a real clock, ROS 2 rounds when a tick was expected.
_CLOSE = 0.02

# The most periods of a run in which lost ticks are worth looking for, where no one has asked for them.
_MOST_PERIODS = 1_000_000


def by_source(ticks: Sequence[Tick]) -> dict[str, list[Tick]]:
    """Group ticks by source; the sources are in the order of their first ticks."""
    groups: dict[str, list[Tick]] = {}
    for tick in ticks:
        groups.setdefault(tick.source, []).append(tick)
    return groups


def topic_ticks(messages: Sequence[Message], topic: str, period: float | None = None) -> list[Tick]:
    """Turn the messages of a topic into ticks without a duration, to be measured or plotted as ticks are.

    ``topic`` is the full name. ``period`` (s) is how far apart the messages should come, counted from the first; None
    stands for the median of how far apart they came.
    """
    times = [message.time for message in messages if message.topic == topic]
    if period is None:
        period = median(later - earlier for earlier, later in pairwise(times)) if len(times) > 1 else 0.0
    return [Tick(topic, number + 1, times[0] + number * period, time, 0.0) for number, time in enumerate(times)]


def rostopic_hz(ticks: Sequence[Tick], window: int = 50_000) -> str:
    """Return what ``rostopic hz`` would print after the last of these ticks, or messages, of one source.

    Of the last ``window`` ticks: the mean rate in Hz, the shortest and the longest period, their standard deviation
    (source: rostopic/__init__.py, ROSTopicHz). It prints ``no new messages`` as long as there is no period.
    """
    times = periods(ticks)[-(window - 1) :] if window > 1 else []
    if not times:
        return "no new messages"
    mean = sum(times) / len(times)
    deviation = math.sqrt(sum((time - mean) ** 2 for time in times) / len(times))
    return (
        f"average rate: {1 / mean if mean > 0 else 0:.3f}\n"
        f"\tmin: {min(times):.3f}s max: {max(times):.3f}s std dev: {deviation:.5f}s window: {len(times) + 1}"
    )


def periods(ticks: Sequence[Tick]) -> list[float]:
    """Return the time from each tick to the next, in seconds. The ticks are of one source."""
    return [later.real - earlier.real for earlier, later in pairwise(ticks)]


def lost(ticks: Sequence[Tick], period: float, coming: Sequence[Tick] = ()) -> list[float]:
    """Return the times (s) that a timer or a rate skipped, on a grid of ``period`` (s) from the first expected tick.

    Each tick stands for the last time on the grid that is not after its expected time. A time is lost if no tick stands
    for it, although one stands for a later time. The ticks are of one source; ``coming`` are those that a Run says
    would have followed, so that what was lost up to the end counts. Raises ValueError for a period that is not above 0.
    """
    if not 0 < period < math.inf:
        raise ValueError(f"a period is above 0 s, not {period!r}")
    ticks = [*ticks, *coming]
    if not ticks:
        return []
    origin = previous = ticks[0].expected
    moved = 0.0
    served = []
    for tick in ticks:
        if tick.expected - previous > 1.5 * period:  # roscpp and rclpy move ``expected`` to the new grid
            moved = 0.0
        due = tick.expected + moved
        served.append(int((due - origin) / period + _CLOSE))
        if tick.real - due > 2 * period:  # rospy leaves it as it was: see ``rospy.Rate.sleep``
            moved = tick.real - tick.expected
        previous = tick.expected
    return [origin + number * period for number in sorted({*range(served[-1])} - {*served})]


def lost_by_source(
    ticks: Sequence[Tick], periods: Mapping[str, float], coming: Sequence[Tick] = ()
) -> dict[str, list[float]]:
    """Return the times (s) that were :func:`lost`, of each source whose period (s) is given and that lost any."""
    found = {}
    following = by_source(coming)
    for source, group in by_source(ticks).items():
        after = following.get(source, [])
        period = periods.get(source, 0.0)
        if period * _MOST_PERIODS > max(tick.real for tick in [*group, *after]):
            found[source] = lost(group, period, after)
    return {source: times for source, times in found.items() if times}


def side_by_side(ticks: Sequence[Tick]) -> int:
    """Return how many of these calls ran at the same time, at most. An overlap below a millisecond does not count."""
    most, ends = 0, list[float]()
    for tick in ticks:
        ends = [*(end for end in ends if end >= tick.real + 1e-3), tick.real + tick.duration]
        most = max(most, len(ends))
    return most


def quantile(values: Sequence[float], share: float) -> float:
    """Return the smallest value that at least the fraction ``share`` (0 to 1) of the values do not exceed.

    ``share`` counts as it is written in decimals: 0.07 of a hundred values are seven of them, although the float is a
    little more. Raises ValueError if there are no values, or if ``share`` is not between 0 and 1.
    """
    if not values:
        raise ValueError("no values")
    if not 0 <= share <= 1:
        raise ValueError(f"a share is from 0 to 1, not {share!r}")
    count = math.ceil(Fraction(str(share)) * len(values))
    return sorted(values)[max(count, 1) - 1]


def say_time(seconds: float) -> str:
    """Format a length of time in a suitable unit: ``0.5 s``, ``1.3 ms``, ``85 µs``."""
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if abs(seconds) >= 0.0995 * size:
            return f"{_three(seconds / size)} {unit}"
    return f"{_three(seconds * 1e6)} µs" if abs(seconds) >= 0.5e-9 else "0 s"


def _three(value: float) -> str:
    """Write three digits that count, and never a power of ten."""
    return f"{float(f'{value:.3g}'):.15g}"


def _say_beside(seconds: float, other: float) -> str:
    """Format a length of time next to another one, in ms if that is shorter."""
    in_ms = 0.5e-6 <= other < 0.0995 <= seconds < 0.9995
    return f"{seconds * 1e3:.3g} ms" if in_ms else say_time(seconds)


def describe_timeline(name: str, group: Sequence[Tick]) -> str:
    """Describe the ticks of one source in a few sentences: their number, first and last time, lateness and overlap."""
    if not group:
        return f"{name}: no ticks."
    span = f"{len(group)} ticks from {group[0].real:.3f} s to {group[-1].real:.3f} s"
    if len(group) == 1:
        span = f"1 tick at {group[0].real:.3f} s"
    most = side_by_side(group)
    return f"{name}: {span}. {describe_lateness(group)}{f' Up to {most} calls ran side by side.' if most > 1 else ''}"


def describe_pace(ticks: Sequence[Tick]) -> str:
    """Say in a few words how many ticks of one source there were, and how far apart."""
    times = periods(ticks)
    if not times:
        return "1 tick" if ticks else "no ticks"
    if max(times) - min(times) < 1e-6:
        return f"{len(ticks)} ticks, one every {say_time(times[0])}"
    return f"{len(ticks)} ticks, {say_time(min(times))} to {say_time(max(times))} apart"


def verdict(ticks: Sequence[Tick], period: float, due: int = 0, coming: Sequence[Tick] = ()) -> str:
    """Say in a few words whether the grid of ``period`` seconds was kept in the end, and how many ticks were lost.

    Also say whether calls still came late in the end, and whether they overlapped. The ticks are of one source, in a
    simulated run, where times are exact. ``due`` is how many ticks were due in that run, if that is known: if the calls
    stopped before the end, the verdict says how many came. ``coming`` are as in :func:`lost`.
    """
    if not ticks:
        return f"never called (0 of {due})" if due else "no ticks"
    count = len(lost(ticks, period, coming))
    losses = f"{count} tick{'' if count == 1 else 's'} lost" if count else "no tick lost"
    last = ticks[-1]
    pause = periods(ticks)[-1:]
    is_even = bool(pause) and abs(pause[0] - period) < 1e-6
    if pause and pause[0] > period * 1.001 and abs(pause[0] - ticks[-2].duration) < 1e-6:
        return f"back to back, every {say_time(pause[0])}, {losses}"
    if len(ticks) + len(lost(ticks, period)) < due - 1:
        losses = f"{len(ticks)} of {due} ticks came"
    # On a new grid ticks are even, but rospy still expects them on the old one.
    if _is_on_grid(last.expected, ticks, period) and 1e-6 < last.lateness and not (is_even and last.lateness > period):
        latest = max(tick.lateness for tick in ticks)
        always = all(abs(tick.lateness - latest) < 1e-6 for tick in ticks)
        return f"{'' if always else 'up to '}{say_time(latest)} late, {losses}"
    grid = "keeps its grid" if _is_on_grid(last.real, ticks, period) else "starts a new grid"
    if side_by_side(ticks) > 1:
        return f"{grid}, overlaps itself{', ' + losses if count else ''}"
    return f"{grid}, {losses}"


def _is_on_grid(time: float, ticks: Sequence[Tick], period: float) -> bool:
    passed = (time - ticks[0].expected) / period
    return abs(passed - round(passed)) < 1e-3


def describe_lateness(ticks: Sequence[Tick]) -> str:
    """Describe the lateness of ticks in a sentence."""
    if not ticks:
        return "There were no ticks."
    late = [tick.lateness for tick in ticks]
    if max(map(abs, late)) < 0.5e-6:
        return "The only tick was on time." if len(late) == 1 else f"All {len(late)} ticks were on time."
    latest = f"{say_time(max(late))} late"
    if len(late) == 1:
        return f"The only tick was {latest}."
    if median(late) < 0.5e-6:
        return f"At least half of the {len(late)} ticks were on time; the latest was {latest}."
    middle = median(late)
    most = f" and 99% at most {_say_beside(quantile(late, 0.99), middle)}" if len(late) >= _MANY else ""
    latest = f"{_say_beside(max(late), middle)} late"
    return f"Half of the {len(late)} ticks were at most {say_time(middle)} late{most}; the latest was {latest}."


def fault_events_by_name(faults: Sequence[FaultEvent]) -> dict[str, list[FaultEvent]]:
    """Group what faults did by what it was and to which it was done: ``/scan from /lidar to /robot dropped``."""
    groups: dict[str, list[FaultEvent]] = {}
    for fault in faults:
        groups.setdefault(f"{fault.which} {fault.what}", []).append(fault)
    return groups


def describe_faults(faults: Sequence[FaultEvent]) -> str:
    """Describe what faults did in a sentence: to which, how often, by how much, when. Nothing, if they did nothing."""
    said = []
    for name, group in fault_events_by_name(faults).items():
        least, most = (say_time(by) for by in (min(each.by for each in group), max(each.by for each in group)))
        by = "" if most == "0 s" == least else f" by {least}" if least == most else f" by {least} to {most}"
        first, last = group[0].time, group[-1].time
        when = f" at {first:.3f} s" if len(group) == 1 else f" {len(group)} times from {first:.3f} s to {last:.3f} s"
        said.append(f"{name}{by}{when}")
    return f"Faults: {'; '.join(said)}." if said else ""


def describe_periods(ticks: Sequence[Tick]) -> str:
    """Describe the periods between ticks of one source in a sentence: their median and how far they spread.

    Of a hundred or more, the shortest and the longest hundredth are left out.
    """
    times = periods(ticks)
    if not times:
        return "There was no second tick, and so no period."
    middle, low, high = median(times), quantile(times, 0.01), quantile(times, 0.99)
    if max(times) - min(times) < 1e-6:
        return f"Every period was {say_time(middle)}; there was no jitter."
    share = f"98% of the {len(times)}" if len(times) >= _MANY else f"all {len(times)}"
    return (
        f"The median period was {middle * 1e3:.3f} ms; {share} periods lay between "
        f"{low * 1e3:.3f} ms and {high * 1e3:.3f} ms: a jitter of {say_time(high - low)}."
    )
