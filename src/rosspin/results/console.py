"""Read log lines and ticks from the console text of any runtime, of either ROS."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Iterator
from itertools import pairwise
from statistics import median
from typing import NamedTuple

from .ticks import Tick

__all__ = ["Line", "read_lines", "read_ticks"]

_COLOUR = re.compile(r"\x1b\[[0-9;]*m")

# rospy stamps in microseconds; roscpp in nanoseconds, and it pads the severity. On ROS time a second stamp follows.
# In ROS 2 the name of the logger follows.
_LINE = re.compile(
    r"\[ ?(?P<severity>DEBUG|INFO|WARN|ERROR|FATAL)\] "
    r"\[(?P<wall>\d+\.\d+)(?:, (?P<ros>\d+\.\d+))?\](?: \[[^]]*\])?: (?P<text>.*)"
)

_COUNTER = re.compile(r"\[(?P<source>[^]]+)\] counter = (?P<number>\d+)")


class Line(NamedTuple):
    """A log line: its severity, its timestamp in seconds (ROS time if it has two) and its text."""

    severity: str
    stamp: float
    text: str


def read_lines(console: str) -> Iterator[Line]:
    """Yield the log lines in a console text. Other lines are skipped, and colour codes are removed."""
    for text in io.StringIO(console, newline=None):  # other separators, such as a form feed, are text
        if match := _LINE.search(_COLOUR.sub("", text)):
            yield Line(match["severity"], float(match["ros"] or match["wall"]), match["text"])


def read_ticks(console: str, period: float | None = None, start: float = 0.0) -> tuple[Tick, ...]:
    """Read the ticks of counting nodes, from lines such as ``[SPINNER CPP NODE] counter = 3``; the tag is the source.

    ``start`` is when the run began, in seconds since the epoch; the times of the ticks count from there. Ticks are
    expected every ``period`` seconds (default: the median period) after the first tick of their source. The console
    does not say how long a tick took, so its duration is NaN.
    """
    found: dict[str, list[tuple[int, float]]] = {}
    order = []
    for line in read_lines(console):
        if match := _COUNTER.match(line.text):
            source, tick = match["source"], (int(match["number"]), line.stamp - start)
            found.setdefault(source, []).append(tick)
            order.append((source, tick))
    periods = {source: period or _median_period(ticks) for source, ticks in found.items()}
    ticks = []
    for source, (number, real) in order:
        first, origin = found[source][0]
        ticks.append(Tick(source, number, origin + (number - first) * periods[source], real, math.nan))
    return tuple(ticks)


def _median_period(ticks: list[tuple[int, float]]) -> float:
    steps = [later - earlier for (_, earlier), (_, later) in pairwise(ticks)]
    return median(steps) if steps else 0.0
