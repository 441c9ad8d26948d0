"""What repeats in a log: lines that differ in numbers only are one series, laid on the grid that fits best."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field
from heapq import nlargest
from itertools import pairwise
from statistics import median, mode

from ..measures import quantile
from .reading import Entry, shape

__all__ = ["FEWEST", "MOST", "MS", "NS", "Gap", "Series", "first_run", "group"]

NS = 10**9
MS = 10**6

# A row of fewer entries says nothing of a period.
FEWEST = 6

# Of more different lines, only the most frequent are series.
MOST = 300

# Periods as someone would choose them (ns): the roundest; those, a whole number of Hz, or such a number of seconds.
_ROUND = sorted(chosen * 10.0**power for chosen in (1, 2, 2.5, 4, 5) for power in range(5, 12))
_RATES = [
    *_ROUND,
    *(NS / hertz for hertz in range(1, 101)),
    *(chosen * 10.0**power for chosen in (1.2, 1.25, 1.5, 3, 6, 7.5, 8) for power in range(5, 12)),
]
_CLOSE = 5e-4  # to which a period is known from some seconds of a log


@dataclass(frozen=True)
class Gap:
    """Nothing came from ``start`` to ``end``, ``excess`` more than a period (ns); ``at`` is the entry that ends it."""

    start: int
    end: int
    excess: int
    at: int


@dataclass(eq=False)
class Series:
    """The entries of one line, topic or table, in the order of the log; times in ns.

    ``counts`` are the numbers in its text that count up, if there are such. ``period`` is 0 if it has none: then it is
    not regular. ``steps`` are the numbers of the entries on the grid, ``late`` says how far each is from there, and
    ``grids`` where new grids begin. ``memory`` is the correlation of a period with the next one: about -0.5 for a timer
    or a rate, where a late tick makes one period longer and the next one shorter; 0 or more if each period begins when
    the last one ends; None if that cannot be said.
    """

    name: str
    node: str
    process: str
    times: list[int]
    texts: list[str]
    counts: list[int] = field(default_factory=list)
    publishers: set[str] = field(default_factory=set)
    part: int = 0  # which of several rows of counts in one line this is, from 1
    per_pass: float = 1  # of several lines that come together each time, how many; only the first are in ``times``
    length: int = 0  # from the first to the last of these (ns)
    is_list: bool = False  # they are not one thing again and again, but always the same list: "leg 1", "leg 2"
    period: float = 0.0
    spread: float = 0.0
    memory: float | None = None
    pairs: int = 0  # from which that is known
    steps: list[int] = field(default_factory=list)
    late: list[float] = field(default_factory=list)
    grids: list[int] = field(default_factory=list)
    gaps: list[Gap] = field(default_factory=list)
    missing: list[int] = field(default_factory=list)
    _order: tuple[list[int], list[int]] | None = field(default=None, repr=False)

    def between(self, first: float, last: float) -> list[int]:
        """Return which entries came from ``first`` to ``last`` (ns), in the order of their times."""
        if self._order is None:
            order = sorted(range(len(self.times)), key=self.times.__getitem__)
            self._order = order, [self.times[n] for n in order]
        order, times = self._order
        return order[bisect_left(times, first) : bisect_right(times, last)]

    @property
    def is_regular(self) -> bool:
        return self.period > 0

    @property
    def line(self) -> str:
        """The line that was logged, with ``#`` for each number."""
        return shape(self.texts[0])[0]

    @property
    def chosen(self) -> float:
        """The period (ns) that someone may have chosen, or a round one that has become longer; 0 if none is near."""
        return nice(self.period, self.close)

    @property
    def drift(self) -> float:
        """By which part the period is longer than the one that someone may have chosen."""
        return self.period / self.chosen - 1 if self.chosen else 0.0

    @property
    def is_chosen(self) -> bool:
        return bool(self.chosen) and abs(self.drift) < self.close

    @property
    def close(self) -> float:
        """To which part the period is known."""
        return max(_CLOSE, 3 * self.spread / (self.period * len(self.times))) if self.is_regular else _CLOSE

    @property
    def is_even(self) -> bool:
        """Whether nearly all entries are near the grid, as a timer's are on an idle machine."""
        return quantile([abs(late) for late in self.late], 0.98) <= max(0.25 * self.period, 3 * MS)

    @property
    def is_quantised(self) -> bool:
        """Whether periods have two lengths and none between, as for a line that is logged now and then only."""
        steps = sorted(b - a for a, b in pairwise(self.times) if 0.5 * self.period < b - a < 1.5 * self.period)
        width, at = max((b - a, n) for n, (a, b) in enumerate(pairwise(steps), 1)) if len(steps) > 1 else (0, 0)
        return (
            0.1 < at / max(1, len(steps)) < 0.9 and width > 0.4 * (steps[-1] - steps[0]) and width > 0.02 * self.period
        )

    @property
    def is_walk(self) -> bool | None:
        """Whether each period begins when the last one ends; None if that cannot be told."""
        if self.memory is None or self.spread < 2_000:
            return None
        # Of few pairs, it may be so by chance.
        if self.memory > max(-0.2, 2.2 / self.pairs**0.5 - 0.5) and not self.is_chosen:
            return True
        return False if self.memory < min(-0.3, -1.8 / self.pairs**0.5) or self.is_chosen else None

    @property
    def keeps_time(self) -> bool:
        """Whether it does not depend on the last period when the next one ends, or nothing says that it does."""
        can_walk = self.memory is not None and self.spread >= 2_000 and self.memory > -0.25
        return not can_walk and (self.is_chosen or self.is_walk is False)

    @property
    def threshold(self) -> float:
        """How much longer than a period is more than jitter (ns)."""
        return max(0.25 * self.period, 8 * MS, 8 * self.spread)


def nice(period: float, close: float = _CLOSE) -> float:
    """Return the period (ns) if someone may have chosen it; else the longest round one below it, if near."""
    if period <= 0:
        return 0.0
    near = [each for each in _RATES if abs(period / each - 1) < close]
    if near:
        return min(near, key=lambda each: abs(period - each))
    found = max((each for each in _ROUND if each < period), default=0.0)
    return found if found > period / 2 else 0.0


def first_run(entries: list[Entry]) -> tuple[list[Entry], list[Entry]]:
    """Split off what comes after the first run: where times go back and lines begin with the numbers of the beginning.

    That is a file to which another one was added, or itself. Where only a clock was set back, numbers continue.
    """
    begin: dict[tuple[str, str, str], list[Entry]] = {}  # the first entries of each line
    for place, entry in enumerate(entries):
        firsts = begin.setdefault((entry.process, entry.node, entry.shape), [])
        if firsts and entry.numbers == firsts[0].numbers and entry.time < entries[place - 1].time - 20 * MS:
            if _begins(entries[place : place + 60], begin):
                return entries[:place], entries[place:]
        if len(firsts) < 3:
            firsts.append(entry)
    return entries, []


def _begins(entries: Sequence[Entry], begin: dict[tuple[str, str, str], list[Entry]]) -> bool:
    again: dict[tuple[str, str, str], list[Entry]] = {}
    for entry in entries:
        again.setdefault((entry.process, entry.node, entry.shape), []).append(entry)
    for line, entries in again.items():
        firsts = begin.get(line, [])
        numbers = [entry.numbers for entry in firsts]
        same = bool(firsts) and [entry.numbers for entry in entries[:3]] == numbers
        if same and (len({*numbers}) > 1 or firsts[0].time == entries[0].time):
            return True
    return False


def group(entries: Sequence[Entry], kind: str) -> tuple[list[Series], int]:
    """Find the series of a log, the most frequent first, each fitted. What several counts run through is split.

    Returns them, and of how many lines, tables or topics they were chosen, if there were too many of these; else 0.
    """
    found: dict[tuple[str, str, str], list[Entry]] = {}
    for entry in entries:
        # A table is one topic, and so is what a bag has of one, whoever published it.
        key = ("", entry.node, "" if kind != "console" else entry.shape)
        found.setdefault((entry.process if kind == "console" else "", *key[1:]), []).append(entry)
    made = []
    for (process, node, text), group in nlargest(MOST, found.items(), key=lambda each: len(each[1])):
        numbers = _counting(group)
        rows = _rows(numbers) if numbers else [list(range(len(group)))]
        for part, row in enumerate(rows, 1):
            members = [group[n] for n in row]
            series = Series(
                _name(node, text, members),
                node,
                process,
                [each.time for each in members],
                [each.text for each in members],
            )
            series.counts = [numbers[n] for n in row] if numbers else []
            series.publishers = {each.process for each in members if each.process}
            series.part = part if len(rows) > 1 else 0
            fit(series)
            made.append(series)
    made.sort(key=lambda series: -len(series.times))
    return made, len(found) if len(found) > MOST else 0


def _name(node: str, text: str, members: Sequence[Entry]) -> str:
    if not text:
        return node or "the topic"
    words = text if len(text) <= 60 else text[:57] + "…"
    return f"{node}: {words}" if node else words


# --- counts -----------------------------------------------------------------------------------------------------------


def _counting(entries: Sequence[Entry]) -> list[int]:
    """Return the numbers at the first place in the text where whole numbers count up; none if there is none."""
    width = min((len(each.numbers) for each in entries), default=0)
    if len(entries) < FEWEST:
        return []
    for place in range(width):
        words = [each.numbers[place] for each in entries]
        if not all(word.isdecimal() and len(word) < 12 for word in words):
            continue
        numbers = [int(word) for word in words]
        ups = sum(1 for one, other in pairwise(numbers) if 0 < other - one < 1000)
        if ups > 0.9 * (len(numbers) - 1):
            return numbers
        rows = _rows(numbers)
        if (
            sum(len(row) for row in rows) >= 0.9 * len(numbers)
            and len(rows) <= 4
            and len(set(numbers)) > len(numbers) / 5
        ):
            return numbers
    return []


def _rows(numbers: Sequence[int]) -> list[list[int]]:
    """Split numbers into rows of which each counts up, as positions; a single row may leave numbers out."""
    ups = sum(1 for one, other in pairwise(numbers) if 0 < other - one < 1000)
    if ups >= len(numbers) - 3:  # at most two restarts
        return [list(range(len(numbers)))]
    waiting: dict[int, list[list[int]]] = {}
    rows: list[list[int]] = []
    for position, number in enumerate(numbers):
        follows = waiting.get(number)
        if follows:
            # Of several that wait for it, the one that has waited longest.
            row = follows.pop(0)
        else:
            rows.append(row := [])
        row.append(position)
        waiting.setdefault(number + 1, []).append(row)
    beside: list[list[int]] = []
    for row in rows:
        if len(row) < FEWEST - 1:
            continue
        for other in beside:
            if other[-1] < row[0]:  # one that begins when another one is over is no second one
                other += row
                break
        else:
            beside.append(row)
    return beside if sum(map(len, beside)) >= 0.85 * len(numbers) else [list(range(len(numbers)))]


# --- the grid ---------------------------------------------------------------------------------------------------------


def fit(series: Series) -> None:
    """Lay a series on the grid that fits best, and find what sticks out."""
    _one_a_pass(series)
    times = series.times
    steps = [later - earlier for earlier, later in pairwise(times)]
    forward = [step for step in steps if step > 0]
    if len(times) < FEWEST or not forward:
        return
    middle = median(forward)
    even = sum(1 for step in steps if abs(step - middle) <= 0.25 * middle) / len(steps)
    if even < 0.35:
        return
    series.period = middle
    for _ in range(2):
        _lay(series)
        _refine(series)
    _lay(series)
    _measure(series, steps)
    # Where passes are often held up, few periods are as they should be, but most ticks are.
    on_grid = sum(1 for late in series.late if abs(late) < 0.15 * series.period) / len(times)
    if even < 0.6 and (on_grid < 0.6 or len(times) < 20):
        _forget(series)


def _forget(series: Series) -> None:
    """Say that a series is not regular."""
    series.period = series.spread = 0.0
    series.memory = None
    series.steps, series.late, series.grids, series.gaps, series.missing = [], [], [], [], []


def _one_a_pass(series: Series) -> None:
    """Of several lines that each pass logs together, keep the first."""
    steps = [later - earlier for earlier, later in pairwise(series.times)]
    if len(steps) < FEWEST:
        return
    large = sorted(steps)[int(0.9 * (len(steps) - 1))]
    firsts = [0, *(n for n, step in enumerate(steps, 1) if step >= 0.2 * large)]
    sizes = [other - one for one, other in pairwise(firsts)]
    usual = round(median(sizes)) if sizes else 1
    if usual < 2 or sum(size > 1 for size in sizes) < 0.8 * len(sizes):
        return
    series.per_pass = usual if sizes.count(usual) >= 0.8 * len(sizes) else sum(sizes) / len(sizes)
    series.length = round(median(series.times[after - 1] - series.times[first] for first, after in pairwise(firsts)))
    series.is_list = _is_list([series.texts[first:after] for first, after in pairwise(firsts)])
    series.times = [series.times[n] for n in firsts]
    series.texts = [series.texts[n] for n in firsts]
    series.counts = [series.counts[n] for n in firsts] if series.counts else []


def _is_list(passes: Sequence[Sequence[str]]) -> bool:
    """Whether lines that come together begin with the same numbers each time, each with another one."""
    begins = [[(shape(text)[1] or ("",))[0] for text in texts] for texts in passes]
    usual = list(mode(map(tuple, begins)))
    return len(set(usual)) == len(usual) > 1 and begins.count(usual) >= 0.8 * len(begins)


def _lay(series: Series) -> None:
    """Number the entries on a grid that follows them slowly, and begins again where several agree that it must."""
    times, period = series.times, series.period
    due, number = float(times[0]), 0
    series.steps, series.late, series.grids = [0], [0.0], [0]
    for n in range(1, len(times)):
        if times[n] < times[n - 1] - period / 2:  # the clock went back
            due, number = float(times[n]), number + 1
            series.grids.append(n)
        else:
            ahead = max(0, round(passed := (times[n] - due) / period))
            if passed > 1.5:  # what comes after a gap was due before: a timer is never early
                ahead = int(passed + 0.1)
            number += ahead
            due += ahead * period
        off = times[n] - due
        series.steps.append(number)
        series.late.append(off)
        due += 0.2 * max(-0.1 * period, min(0.1 * period, off))
        last = series.late[-4:]
        if (
            n - series.grids[-1] >= 4
            and abs(off) > 0.08 * period
            and max(last) - min(last) < 0.1 * abs(off) + 0.02 * period
        ):
            due = float(times[n])
            series.grids.append(n - 3)


def _runs(series: Series) -> list[range]:
    """Return the parts of a series that are on one grid, as positions."""
    return [range(one, other) for one, other in pairwise([*series.grids, len(series.times)]) if other > one]


def _refine(series: Series) -> None:
    """Fit a line through the times of all grids together: by least squares, without what is far off."""
    across = up = 0.0
    for run in _runs(series):
        near = [n for n in run if abs(series.late[n]) < 0.25 * series.period]
        if len(near) < 4:
            continue
        steps = [series.steps[n] for n in near]
        first = series.times[near[0]]
        middle = sum(steps) / len(steps)
        across += sum((step - middle) ** 2 for step in steps)
        up += sum((step - middle) * (series.times[n] - first) for n, step in zip(near, steps, strict=True))
    if across and 0.8 * series.period < up / across < 1.25 * series.period:
        series.period = up / across


def _measure(series: Series, steps: Sequence[int]) -> None:
    period = series.period
    for run in _runs(series):
        zero = [series.times[n] - series.steps[n] * period for n in run]
        middle = median(zero)
        for n, each in zip(run, zero, strict=True):
            series.late[n] = each - middle
        numbers = [series.steps[n] for n in run]
        for one, other in pairwise(numbers):
            if other - one < 10_000:
                series.missing += [round(middle + number * period) for number in range(one + 1, other)]
    even = [step if 0.5 * period < step < 1.5 * period else None for step in steps]
    good = [step for step in even if step is not None]
    centre = median(good)
    series.spread = median(abs(step - centre) for step in good)
    off = [step if step is None else max(-3 * series.spread, min(3 * series.spread, step - centre)) for step in even]
    pairs = [(one, other) for one, other in pairwise(off) if one is not None and other is not None]
    series.pairs = len(pairs)
    if len(pairs) >= 12 and series.spread:
        middle = sum(one for one, _ in pairs) / len(pairs)
        across = sum((one - middle) ** 2 for one, _ in pairs)
        series.memory = sum((one - middle) * (other - middle) for one, other in pairs) / across if across else None
    for n, step in enumerate(steps):
        if step - period > series.threshold:
            series.gaps.append(Gap(series.times[n], series.times[n + 1], round(step - period), n + 1))
