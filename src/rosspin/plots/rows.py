"""The rows of a timeline: made from ticks, described, and drawn by matplotlib where :mod:`.layout` says."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..measures import describe_pace, describe_timeline, fault_events_by_name, lost, verdict
from ..results.ticks import FaultEvent, Tick
from . import layout, pictures
from .layout import AXIS, KINDS, MANY, REACH, ROW, TICKS, TITLE, to_draw

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    *("COLOURS", "MARKS", "Period", "Row", "describe", "draw_rows", "fault_rows", "height_of"),
    *("make_row", "make_rows", "said_if_fewer", "times_of", "title"),
]

# The period (s) of all rows, or of some rows by their names.
Period = float | Mapping[str, float] | None

# What is not about ticks comes last: the faults.
COLOURS = (*layout.COLOURS, "black")
MARKS: tuple[dict[str, Any], ...]
MARKS = (
    *({"marker": "o", "mew": 0}, {"marker": "s", "mew": 0}, {"marker": "o", "mew": 2, "mfc": "none", "ms": 7}),
    {"marker": "v", "mew": 0, "ms": 7},
)
_FAULT = KINDS

_MOST_LINES = 1_000_000


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


def fault_rows(faults: Mapping[str, Sequence[FaultEvent]]) -> list[Row]:
    """Make a row for each fault, by the names of the runs; one without a name is alone."""
    rows = []
    for run, fault_events in faults.items():
        for name, group in fault_events_by_name(fault_events).items():
            marks = [(round(each.time, 6), round(max(each.by, 0.0), 6)) for each in group if math.isfinite(each.time)]
            marks = [(time, 0.0 if group[0].what == "set" else by) for time, by in marks]
            rows.append(Row(f"{run}: {name}" if run else name, "", [], [], marks))
    return rows


def times_of(rows: Iterable[Row]) -> Iterator[float]:
    """Yield the times that the axis has to reach."""
    for row in rows:
        yield from (*row.expected, *(real + duration for real, duration in row.ticks))


def title(period: Period) -> str:
    """Return what is written below the axis of time."""
    return TITLE + (", cross: lost" if period else "")


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
    """Draw the rows, and then one for each of ``faults``.

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
        ax.margins(x=pictures.margin(layout.MARGIN))
        ax.set_ylim(len(rows), 0)
        pictures.number(ax, layout.numbers)
        ax.xaxis.set_major_formatter("{x:.9g}")
    return ax


def height_of(rows: Sequence[Row]) -> int:
    """Return the height (px) of a timeline's own figure."""
    return ROW * len(rows) + AXIS + (16 if any(len(row.ticks) > MANY for row in rows) else 0)


def _draw_row(ax: Axes, number: int, row: Row, kind: int) -> int:
    """Draw a row, 1 high, and return how many marks it has."""
    middle = number + TICKS / ROW
    lanes, height = layout.lanes(row.ticks)
    heights = layout.heights(row.ticks)
    few = to_draw([real for real, _ in row.ticks], [duration for _, duration in row.ticks])
    bars = [(middle + lanes[n] / ROW, *row.ticks[n]) for n in few if row.ticks[n][1]]
    lines, crosses = ([times[n] for n in to_draw(times, [0.0] * len(times))] for times in (row.expected, row.lost))
    reach = REACH / ROW
    ax.vlines(lines, middle - reach, middle + reach, colors="black", alpha=0.55, lw=1, zorder=0.8)
    if bars:
        down, left, width = zip(*bars, strict=True)
        ax.barh(down, width, height / ROW, left, color=COLOURS[kind], alpha=0.45)
    ax.plot(crosses, [middle] * len(crosses), "x", c="black", ms=10)
    places = [(row.ticks[n][0], middle + heights[n] / ROW) for n in few]
    ax.plot(*zip(*places, strict=True) if places else ((), ()), ls="", c=COLOURS[kind], **MARKS[kind])
    if row.words:
        ax.text(1, number, row.words, transform=ax.get_yaxis_transform(), ha="right", va="top")
    return len(few)


def said_if_fewer(drawn: int, of: int) -> str:
    """Say how many ticks are drawn, for the axis; an empty text if all are."""
    return f"\n{drawn:,} of {of:,} ticks drawn" if drawn < of else ""
