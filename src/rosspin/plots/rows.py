"""The rows of a timeline: made from ticks, described and drawn. web/src/svg.js draws them in the same way."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..measures import describe_pace, describe_timeline, lost, mishaps_by_name, verdict
from ..results.ticks import Mishap, Tick
from . import pictures

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    *("AXIS", "BAR", "COLOURS", "COLUMNS", "KINDS", "MARKS", "ROW", "TICKS", "Period", "Row", "describe", "draw_rows"),
    *("fault_rows", "height_of", "make_row", "make_rows", "said_if_fewer", "times_of", "title", "to_draw"),
]

# The period (s) of all rows, or of some rows by their names.
Period = float | Mapping[str, float] | None

KINDS = 3  # of rows, each with a colour and a mark of its own
# Blue, vermilion and green of Okabe and Ito's colour-blind-safe set: at least 3:1 on white and on near-black alike.
# What is not about ticks comes last: the faults.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "black")
MARKS: tuple[dict[str, Any], ...]
MARKS = (
    *({"marker": "o", "mew": 0}, {"marker": "s", "mew": 0}, {"marker": "o", "mew": 2, "mfc": "none", "ms": 7}),
    {"marker": "v", "mew": 0, "ms": 7},
)
_FAULT = KINDS

_MANY = 600  # the most marks in a row: more would run into each other
COLUMNS = 120  # of a row in which not all marks are drawn
_MOST_LINES = 1_000_000

# A timeline in a figure of its own, in points.
ROW = 54  # its name, and below that its ticks
TICKS = 34  # how far the middle of the ticks is below the top of their row
_REACH = 13  # how far a line for an expected tick goes up and down from there
BAR = 10  # how high the bar of a call is
_ABOVE, _MOST_ABOVE = 10, 2  # how far a tick is above one that came at the same time, and for how many ticks
AXIS = 42  # with its numbers and its title
_MARGIN = 0.0135  # half a mark, as a fraction of the width


def describe(
    groups: Mapping[str, Sequence[Tick]],
    period: Period,
    coming: Mapping[str, Sequence[Tick]],
    position: str = "",
) -> str:
    """Say in words what a timeline shows; ``position`` follows its first word."""
    words = []
    for name, group in groups.items():
        own = _period_of(name, period)
        gone = len(lost(group, own, coming.get(name, ()))) if own else 0
        words.append(describe_timeline(name, group) + (f" Lost ticks: {gone}." if own and (group or gone) else ""))
    return f"Timeline{position}. " + " ".join(words)


class Row(NamedTuple):
    """What a row of a timeline shows: all times in seconds, to the microsecond."""

    name: str
    words: str
    expected: list[float]
    lost: list[float]
    ticks: list[tuple[float, float]]  # when each came and how long it took; 0 where that is not known


def make_rows(
    groups: Mapping[str, Sequence[Tick]],
    period: Period,
    coming: Mapping[str, Sequence[Tick]],
    worded: bool = False,
) -> list[Row]:
    """Make the rows of a timeline, ``worded`` with a few words on each. One without ticks has the others' grid."""
    periods = {name: _period_of(name, period) for name in groups}
    for each in periods.values():
        if each is not None and not 0 < each < math.inf:
            raise ValueError(f"a period is above 0 s, not {each!r}")
    rows = [make_row(name, group, periods[name], coming.get(name, ())) for name, group in groups.items()]
    grid = max((row.expected for row in rows), key=len)
    due = len(grid)
    for number, (name, group) in enumerate(groups.items()):
        own = periods[name]
        words = (verdict(group, own, due, coming.get(name, ())) if own else describe_pace(group)) if worded else ""
        expected = rows[number].expected or (grid if own else [])
        rows[number] = rows[number]._replace(words=words, expected=expected)
    return rows


def _period_of(name: str, period: Period) -> float | None:
    return period.get(name) if isinstance(period, Mapping) else period


def make_row(name: str, group: Sequence[Tick], period: float | None, coming: Sequence[Tick]) -> Row:
    """Make a row of these ticks, with the grid of a period and the ticks that are lost."""
    expected, gone = {tick.expected for tick in group}, list[float]()
    if period and (group or coming):
        origin = next(iter([*group, *coming])).expected
        last = max([origin, *(tick.real for tick in [*group, *coming])])
        if (last - origin) / period > _MOST_LINES:
            raise ValueError(f"a period of {period:g} s is too short for ticks up to {last:g} s")
        gone = lost(group, period, coming)
        overdue = [tick.expected for tick in coming if tick.lateness > 0]
        steps = (max([origin, *(tick.real for tick in group[-1:]), *gone, *overdue]) - origin) / period + 1e-3
        expected = {*gone, *(origin + step * period for step in range(int(steps) + 1))}
    times = sorted({round(time, 6) for time in expected})
    ticks = [(round(tick.real, 6), round(tick.duration, 6) if tick.duration > 0 else 0.0) for tick in group]
    return Row(name, "", times, [round(time, 6) for time in gone], ticks)


def fault_rows(faults: Mapping[str, Sequence[Mishap]]) -> list[Row]:
    """Make a row for each fault, by the names of the runs; one without a name stands alone."""
    rows = []
    for run, mishaps in faults.items():
        for name, group in mishaps_by_name(mishaps).items():
            marks = [(round(each.time, 6), round(max(each.by, 0.0), 6)) for each in group if math.isfinite(each.time)]
            marks = [(time, 0.0 if group[0].what == "set" else by) for time, by in marks]
            rows.append(Row(f"{run}: {name}" if run else name, "", [], [], marks))
    return rows


def times_of(rows: Iterable[Row]) -> Iterator[float]:
    """Yield the times that the axis has to reach."""
    for row in rows:
        yield from (*row.expected, *(real + duration for real, duration in row.ticks))


def title(period: Period) -> str:
    """Return what stands below the axis of time."""
    return "time (s); line: expected, mark: real" + (", cross: lost" if period else "")


def draw_rows(
    rows: Sequence[Row],
    period: Period,
    kinds: int,
    alt: str,
    caption: str,
    ax: Axes | None,
    times: Iterable[float],
    faults: Sequence[Row] = (),
) -> Axes:
    """Draw the rows, and then those of ``faults``.

    The axis of time begins with the run and has room for these ``times``, too.
    """
    known = [*(number % kinds % KINDS for number in range(len(rows))), *[_FAULT] * len(faults)]
    rows = [*rows, *faults]
    with pictures.drawing(ax, alt, caption, height_of(rows)) as ax:
        drawn = sum(_draw_row(ax, number, row, known[number]) for number, row in enumerate(rows))
        ax.set_yticks(range(len(rows)), [row.name for row in rows], ha="left", va="top", weight="bold")
        ax.tick_params(axis="y", length=0, pad=0)
        ax.grid(visible=False)
        ax.set_xlabel(title(period) + said_if_fewer(drawn, sum(len(row.ticks) for row in rows)), loc="right")
        ax.update_datalim([(time, 0) for time in (0.0, *times) if math.isfinite(time)])
        ax.use_sticky_edges = False
        ax.margins(x=_MARGIN)
        ax.set_ylim(len(rows), 0)
        ax.locator_params("x", nbins=7, steps=[1, 2, 5, 10])
        ax.xaxis.set_major_formatter("{x:.9g}")
    return ax


def height_of(rows: Sequence[Row]) -> int:
    """Return the height (px) of a timeline's own figure."""
    return ROW * len(rows) + AXIS + (16 if any(len(row.ticks) > _MANY for row in rows) else 0)


def _draw_row(ax: Axes, number: int, row: Row, kind: int) -> int:
    """Draw a row, 1 high, and return how many marks it has."""
    middle = number + TICKS / ROW
    lanes, height = _lanes(row.ticks)
    few = to_draw([real for real, _ in row.ticks], [duration for _, duration in row.ticks])
    bars = [(middle + lanes[n], *row.ticks[n]) for n in few if row.ticks[n][1]]
    lines, crosses = ([times[n] for n in to_draw(times, [0.0] * len(times))] for times in (row.expected, row.lost))
    reach = _REACH / ROW
    ax.vlines(lines, middle - reach, middle + reach, colors="black", alpha=0.55, lw=1, zorder=0.8)
    if bars:
        down, left, width = zip(*bars, strict=True)
        ax.barh(down, width, height, left, color=COLOURS[kind], alpha=0.45)
    ax.plot(crosses, [middle] * len(crosses), "x", c="black", ms=10)
    # Ticks at the same time are drawn one above the other, as far as there is room.
    above, before, places = 0, (-math.inf, 0.0), []
    for n in few:
        place = row.ticks[n][0], lanes[n]
        above = min(above + 1, _MOST_ABOVE) if place[0] - before[0] < 1e-3 and place[1] == before[1] else 0
        places.append((place[0], middle + place[1] - above * _ABOVE / ROW))
        before = place
    ax.plot(*zip(*places, strict=True) if places else ((), ()), ls="", c=COLOURS[kind], **MARKS[kind])
    if row.words:
        ax.text(1, number, row.words, transform=ax.get_yaxis_transform(), ha="right", va="top")
    return len(few)


def _lanes(ticks: Sequence[tuple[float, float]]) -> tuple[list[float], float]:
    """Return how far down each call of a row is, and how high its bar: calls that overlap get a lane each."""
    ends: list[float] = []  # of the last call in each lane
    taken = []
    for real, duration in ticks:
        lane = next((lane for lane, end in enumerate(ends) if end < real + 1e-3), len(ends))
        ends[lane : lane + 1] = [real + duration]
        taken.append(lane)
    pitch = 2 * _REACH / max(len(ends), 1)
    return [(lane - (len(ends) - 1) / 2) * pitch / ROW for lane in taken], max(min(BAR, pitch - 1), 0.5) / ROW


def to_draw(across: Sequence[float], up: Sequence[float]) -> list[int]:
    """Return which points to draw: all, or, if they are many, the lowest and the highest in each column."""
    if len(across) <= _MANY:
        return list(range(len(across)))
    first = min(across)
    width = (max(across) - first) / COLUMNS or 1.0
    columns: dict[int, tuple[int, int]] = {}
    for n, (x, y) in enumerate(zip(across, up, strict=True)):
        low, high = columns.setdefault(int((x - first) / width), (n, n))
        columns[int((x - first) / width)] = (n if y < up[low] else low, n if y > up[high] else high)
    return sorted({n for pair in columns.values() for n in pair})


def said_if_fewer(drawn: int, of: int) -> str:
    """Say how many ticks are drawn, for the axis; an empty text if all are."""
    return f"\n{drawn:,} of {of:,} ticks drawn" if drawn < of else ""
