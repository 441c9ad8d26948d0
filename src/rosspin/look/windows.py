"""The times at which lines were silent together, and what came meanwhile."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from statistics import median

from .series import MS, Gap, Series

__all__ = ["Window", "every", "find_windows", "node_of"]

# A machine has such hiccups (ns) now and then, and they are no one's fault.
_HICCUP = 30 * MS

# So near (ns) is at the same time, for what two callbacks of one thread log one after the other.
_AT_ONCE = 5 * MS


def node_of(series: Series) -> str:
    """Return what runs by itself, as far as the log says: the process or the node; "" if it names none."""
    return series.process or series.node


@dataclass
class Window:
    """Lines that were silent at the same time (the ``late`` ones, each with its gap), and those that came meanwhile."""

    late: list[tuple[Series, Gap]]
    on_time: list[Series] = field(default_factory=list)

    @property
    def lines(self) -> list[Series]:
        return [series for series, _ in self.late]

    @property
    def start(self) -> int:
        return max(gap.start for _, gap in self.late)

    @property
    def due(self) -> float:
        """When the first of what did not come was due."""
        return min(gap.start + series.period for series, gap in self.late)

    @property
    def end(self) -> int:
        return min(gap.end for _, gap in self.late)

    @property
    def length(self) -> int:
        return self.end - self.start

    def of(self, node: str) -> Window:
        """Return the part of this that is about one node."""
        return Window([(series, gap) for series, gap in self.late if node_of(series) == node], self.on_time)

    def is_clock(self) -> bool | None:
        """Whether all stepped by the same time; False if all came again at the same time; None if that is the same."""
        ends = [gap.end for _, gap in self.late]
        steps = [gap.excess for _, gap in self.late]
        apart, unequal = max(ends) - min(ends), max(steps) - min(steps)
        if unequal < 12 * MS and apart > max(25 * MS, 2.5 * unequal):
            return True
        return False if apart < 40 * MS and unequal > max(15 * MS, 1.7 * apart) else None

    def came(self, series: Series) -> bool:
        """Whether a line came meanwhile, and not late itself."""
        excess = median(gap.excess for _, gap in self.late)
        inside = series.between(self.start + 1, self.end - 1)
        return any(not series.is_regular or series.late[n] < 0.3 * excess for n in inside)

    def goes_on(self, series: Series) -> bool:
        """Whether a line comes in the middle: then it is not what the others wait for."""
        return bool(series.between(self.due + _AT_ONCE, self.end - 0.25 * (self.end - self.due)))

    def entries_at_start(self, series: Series) -> list[int]:
        """Return the entries of a line that come where this begins: before the first tick that was due in it."""
        return series.between(self.start - _AT_ONCE, self.due + _AT_ONCE)

    def entries_at_end(self, series: Series) -> list[int]:
        """Return the entries of a line that come where this ends; of a late one that is no wonder."""
        return [] if series in self.lines else series.between(self.end - 0.1 * self.length, self.end + 2 * _AT_ONCE)


def find_windows(rows: Sequence[Series], leave_out: Callable[[Series, Gap], bool]) -> list[Window]:
    """Put the gaps of all regular lines together that are at the same time. Some are left out, and single hiccups."""
    gaps = []
    for series in _leading(rows):
        own = [gap for gap in series.gaps if gap.at > 5 and not leave_out(series, gap)]  # not at the start
        least = max(series.period, _HICCUP)
        if sum(gap.excess < least for gap in own) <= max(2, 0.01 * len(series.times)):
            own = [gap for gap in own if gap.excess > min(least, _HICCUP)]
        gaps += [(series, gap) for gap in own]
    windows: list[Window] = []
    for series, gap in sorted(gaps, key=lambda each: each[1].end):
        for window in reversed(windows[-8:]):
            both = min(window.end, gap.end) - max(window.start, gap.start)
            if both > 0.5 * min(window.length, gap.end - gap.start) and series not in window.lines:
                window.late.append((series, gap))
                break
        else:
            windows.append(Window([(series, gap)]))
    for window in windows:
        window.on_time = [series for series in rows if series not in window.lines and window.came(series)]
    return windows


def _leading(rows: Sequence[Series]) -> list[Series]:
    """Return the regular lines, but of several that one pass logs the first alone."""
    leading: list[Series] = []
    for series in sorted((series for series in rows if series.is_regular), key=lambda series: series.times[0]):
        if not any(_accompanies(series, other) for other in leading):
            leading.append(series)
    return leading


def _accompanies(series: Series, other: Series) -> bool:
    """Whether a line comes with each of another one of its node."""
    if node_of(series) != node_of(other) or series.part != other.part or abs(len(series.times) - len(other.times)) > 2:
        return False
    both = list(zip(series.times, other.times, strict=False))
    return sum(1 for one, first in both if abs(one - first) < 0.05 * series.period) > 0.9 * len(both)


def every(windows: Sequence[Window]) -> int:
    """Of how many passes of a line one is slow, if it is always as many; 0 if not, or if several lines are late."""
    if any(len(window.late) > 1 or window.lines != windows[0].lines for window in windows):
        return 0
    counts = [gap.at for window in windows for _, gap in window.late]
    series = windows[0].lines[0]
    if series.counts:
        counts = [series.counts[at] for at in counts]
    steps = {other - one for one, other in pairwise(counts)}
    return steps.pop() if len(counts) > 2 and len(steps) == 1 else 0
