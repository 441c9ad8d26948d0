"""Plot ticks with matplotlib: each function draws into an Axes and returns it. All else is plain matplotlib.

``ax`` is where to draw: by default in a new figure of pyplot's. ``caption`` says where the data come from; a page shows
it below the plot. For a simulated :class:`~rosspin.Run` it is "simulated". The label of the Axes says what is drawn, as
the text alternative of the picture: ``ax.set_label(words)`` replaces it. matplotlib knows the style by the name
``rosspin.plots.rosspin``.

If a row has more than 600 ticks, only those that stand out are drawn, and the axis says how many. Raises ValueError if
there are no ticks, if a time is not finite, or if a period is not above 0; and ImportError without matplotlib, which
``pip install 'rosspin[plot]'`` installs.
"""

from __future__ import annotations

import html
import json
import math
import textwrap
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any, NamedTuple

from ..measures import (
    by_source,
    describe_faults,
    describe_lateness,
    describe_pace,
    describe_periods,
    describe_timeline,
    lost,
    mishaps_by_name,
    periods,
    verdict,
)
from ..results.orders import Instant, Orders, Step
from ..results.ticks import Mishap, Run, Tick
from . import pictures

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = [
    *("Movable", "both_orders", "compare", "lateness", "orders", "overview", "period_histogram", "picture"),
    *("timeline", "with_handle"),
]

# The ticks of a run; and what a plot shows: such ticks, named by their source, or several by the names to give them.
One = Run | Sequence[Tick]
Ticks = One | Mapping[str, One]
# The period (s) of all rows, or of some rows by their names.
Period = float | Mapping[str, float] | None

_KINDS = 3  # of rows, each with a colour and a mark of its own
# Blue, vermilion and green of Okabe and Ito's colour-blind-safe set: at least 3:1 on white and on near-black alike.
# What is not about ticks comes last: the faults.
_COLOURS = ("#0072b2", "#d55e00", "#009e73", "black")
_MARKS: tuple[dict[str, Any], ...]
_MARKS = (
    *({"marker": "o", "mew": 0}, {"marker": "s", "mew": 0}, {"marker": "o", "mew": 2, "mfc": "none", "ms": 7}),
    {"marker": "v", "mew": 0, "ms": 7},
)
_FAULT = _KINDS

_MANY = 600  # the most marks in a row: more would run into each other
_COLUMNS = 120  # of a row in which not all marks are drawn
_BINS = 40
_MOST_LINES = 1_000_000

# A timeline in a figure of its own, in points.
_ROW = 54  # its name, and below that its ticks
_TICKS = 34  # how far the middle of the ticks is below the top of their row
_REACH = 13  # how far a line for an expected tick goes up and down from there
_BAR = 10
_ABOVE, _MOST_ABOVE = 10, 2  # how far a tick is above one that came at the same time, and for how many ticks
_AXIS = 42  # with its numbers and its title
_PLOT = 220  # of the plots below it
_MARGIN = 0.0135  # half a mark, as a fraction of the width


def timeline(
    ticks: Ticks,
    period: Period = None,
    kinds: int = _KINDS,
    end: float = 0.0,
    *,
    faults: Sequence[Mishap] = (),
    caption: str | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Plot when each tick was expected and when it came, in seconds; a bar shows how long it took.

    With ``period`` (s, above 0), there is a line for every period, even where no tick came, and a cross for every
    lost tick, in a simulated Run up to its end; ``{"callback": 0.5}`` does so in one row. The rows take turns with
    up to three ``kinds``, each with its own mark and colour. Calls that overlap have a lane each. The axis goes to
    the last tick, or to the ``end`` of the run (s), which a Run knows. What ``faults`` did, which a Run knows, too,
    has rows of its own, with triangles; a bar shows by how much something came late.
    """
    groups = _groups(ticks)
    coming = _coming(ticks)
    rows = _rows(groups, period, coming)
    runs = ticks.values() if isinstance(ticks, Mapping) else [ticks]
    ends = [end, *(run.seconds for run in runs if isinstance(run, Run))]
    went_wrong = _faults(ticks, faults)
    alt = " ".join([_describe(groups, period, coming), *map(describe_faults, filter(None, went_wrong.values()))])
    return _timeline(rows, period, kinds, alt, _caption(caption, ticks), ax, ends, _fault_rows(went_wrong))


def picture(
    ticks: Ticks,
    period: Period = None,
    kinds: int = _KINDS,
    end: float = 0.0,
    *,
    faults: Sequence[Mishap] = (),
    caption: str | None = None,
) -> Figure:
    """A :func:`timeline` in a figure that pyplot does not know: no window opens, and nobody has to close it."""
    ax = pictures.new_axes(_height([*_rows(_groups(ticks), None, {}), *_fault_rows(_faults(ticks, faults))]))
    return pictures.figure_of(timeline(ticks, period, kinds, end, faults=faults, caption=caption, ax=ax))


def overview(ticks: Ticks, *, caption: str | None = None) -> Figure:
    """A :func:`timeline`, the :func:`lateness` and a :func:`period_histogram` below each other, unknown to pyplot."""
    heights = [_height(_rows(_groups(ticks), None, {})), _PLOT, _PLOT]
    axes = pictures.new_column(heights)
    for draw, ax in zip((timeline, lateness, period_histogram), axes, strict=True):
        draw(ticks, caption=caption, ax=ax)
        if legend := ax.get_legend():  # the rows of the timeline name the colours, and need less room
            legend.remove()
    return pictures.figure_of(axes[0])


def compare(
    runs: Mapping[str, One], period: float | None = None, *, caption: str | None = None, ax: Axes | None = None
) -> Axes:
    """Plot several runs one below the other, on one axis of time: ``{"Timer": run, "Rate": other_run}``.

    Each run has a row for each of its timers and loops. The same source has the same colour in all runs. The rest is as
    in :func:`timeline`.
    """
    by_run = {name: by_source(_ticks(run)) for name, run in runs.items()}
    sources = list(dict.fromkeys(source for groups in by_run.values() for source in groups))
    caption = _caption(caption, runs)
    if all(len(groups) < 2 for groups in by_run.values()):
        return timeline(runs, period, caption=caption, ax=ax)
    rows = {f"{name}: {source}": by_run[name].get(source, []) for name in runs for source in sources}
    end = max(run.seconds if isinstance(run, Run) else 0.0 for run in runs.values())
    return timeline(rows, period, len(sources), end, caption=caption, ax=ax)


def lateness(ticks: Ticks, *, caption: str | None = None, ax: Axes | None = None) -> Axes:
    """Plot how late each tick was (ms) against the time at which it was expected (s)."""
    groups = _groups(ticks)
    words = [f"{name}: {describe_lateness(group)}" for name, group in groups.items()]
    with pictures.drawing(ax, "Lateness of each tick. " + " ".join(words), _caption(caption, ticks)) as ax:
        ax.axhline(0, color="black", alpha=0.55, lw=1, zorder=0.8)
        drawn = 0
        for row, (name, group) in enumerate(groups.items()):
            across, up = [tick.expected for tick in group], [tick.lateness * 1e3 for tick in group]
            few = _few(across, up)
            drawn += len(few)
            mark = _MARKS[row % _KINDS] | {"ms": 5 if len(few) <= _COLUMNS else 3, "mew": row % _KINDS // 2}
            colour = _COLOURS[row % _KINDS]
            ax.plot([across[n] for n in few], [up[n] for n in few], ls="", c=colour, label=name, **mark)
        ax.set_xlabel("time expected (s)" + _said(drawn, sum(map(len, groups.values()))), loc="right")
        ax.set_ylabel("lateness (ms)")
        _name(ax, groups)
    return ax


def period_histogram(ticks: Ticks, *, caption: str | None = None, ax: Axes | None = None) -> Axes:
    """Plot how often each period (ms) between two ticks occurred. The bars of several groups stand side by side."""
    groups = _groups(ticks)
    words = [f"{name}: {describe_periods(group)}" for name, group in groups.items()]
    times = [[period * 1e3 for period in periods(group)] for group in groups.values()]
    found = [time for group in times for time in group]
    first, last = min(found, default=0.0), max(found, default=1.0)
    if last - first <= 1e-6 * abs(last):  # differences by rounding alone have no bins
        first, last = first - 0.05 * (abs(first) or 1.0), last + 0.05 * (abs(last) or 1.0)
    with pictures.drawing(ax, "Distribution of periods. " + " ".join(words), _caption(caption, ticks)) as ax:
        colours = [_COLOURS[row % _KINDS] for row in range(len(groups))]
        ax.hist(times, bins=_BINS, range=(first, last), color=colours, label=list(groups))
        ax.locator_params("y", integer=True)
        ax.set_xlabel("period (ms)", loc="right")
        ax.set_ylabel("number of periods")
        _name(ax, groups)
    return ax


@dataclass(frozen=True)
class Movable:
    """A timeline that the reader of a page moves, made by :func:`with_handle`. A notebook displays it as ``html``."""

    html: str
    alt: str

    def _repr_html_(self) -> str:
        return self.html

    def __repr__(self) -> str:
        return f"<Movable: {self.alt}>"


def with_handle(
    label: str,
    unit: str,
    runs: Mapping[float, Ticks],
    at: float,
    period: float | None = None,
    sets: str = "",
    kinds: int = _KINDS,
    *,
    caption: str | None = None,
) -> Movable:
    """Plot a timeline that the reader of a page moves: ``runs`` are the ticks for each position of a handle.

    ``label`` and ``unit`` say what the position is. ``at`` is the position shown first, and the only one in print or
    without the page's script, which draws the others. ``period`` and ``kinds`` are those of :func:`timeline`; with a
    period, each row says whether the grid was kept and how many ticks were lost. ``sets`` names the variable that has
    the position as its value in the code beside the plot.

    Raises ValueError if ``at`` is no position, or if there is one without ticks.
    """
    if at not in runs:
        raise ValueError(f"{at!r} is no position of the handle: they are {', '.join(map(repr, runs))}")
    positions = {value: _groups(ticks) for value, ticks in runs.items()}
    coming = {value: _coming(ticks) for value, ticks in runs.items()}
    rows = {value: _rows(groups, period, coming[value], worded=True) for value, groups in positions.items()}
    times = [0.0, *(time for group in rows.values() for time in _times(group))]
    said = {value: html.escape(f"{value:g} {unit}") for value in runs}
    alts = {
        value: _describe(groups, period, coming[value], f", {label}: {value:g} {unit}")
        for value, groups in positions.items()
    }
    data = {
        "first": min(times),
        "span": max(times) - min(times) or 1.0,
        "kinds": kinds,
        "title": _title(period),
        "sets": sets,
        "positions": [[f"{value:g}", f"{value:g} {unit}", alts[value], rows[value]] for value in runs],
    }
    handle = (
        f'<label class="rosspin-handle" hidden>{html.escape(label)} ({html.escape(unit)}) '
        f'<b aria-hidden="true">{said[at]}</b> <input type="range" min="0" max="{len(runs) - 1}" step="1" '
        f'value="{list(runs).index(at)}" autocomplete="off" aria-valuetext="{said[at]}"></label>'
    )
    ax = pictures.new_axes(_height(rows[at]))
    _timeline(rows[at], period, kinds, alts[at], _caption(caption, runs[at]), ax, times)
    packed = json.dumps(data, separators=(",", ":"), ensure_ascii=False)
    return Movable(pictures.page(pictures.figure_of(ax), handle, packed), alts[at])


# --- two orders of one run --------------------------------------------------------------------------------------------

_PANELS = ("the usual order", "this order")
_STEPS = 16  # the most steps that are drawn of each order
_LINE = 16  # of text, in points
_CHARACTERS = 50  # of such a line on a phone


def orders(found: Orders, *, caption: str | None = None, ax: Axes | None = None) -> Axes:
    """Plot an order that :func:`rosspin.explore` has found below the usual one, step by step, where they differ.

    Each order has a row for each thread. A mark is a line of the node, with its number; a bar goes on for as long as
    its thread does. What comes first is on the left, also within an instant; each instant has a ground of its own, with
    its time below. A dashed line shows where the orders part, and what was chosen there. Up to 16 steps are drawn.

    Raises ValueError if no lines are known, as of functions, or if all of them are the same.
    """
    shown, left = _windows(found.instants)
    if not shown:
        raise ValueError("the two orders have no lines that differ")
    threads = list(dict.fromkeys(step.thread for window in shown for column in window.steps for step in column if step))
    gap = sum(len(window.parting) for window in shown) * _LINE / _ROW + 0.2
    caption = "simulated" if caption is None else caption
    alt = " ".join(_describe_orders(window) for window in shown)
    with pictures.drawing(ax, f"Two orders of one run, step by step. {alt}", caption, _orders_height(found)) as ax:
        places = {
            (panel, thread): panel * (len(threads) + gap) + number
            for panel in range(len(_PANELS))
            for number, thread in enumerate(threads)
        }
        bottom = 2 * len(threads) + gap
        for number, window in enumerate(shown):
            if number % 2:
                ax.axvspan(window.first - 0.5, window.end - 0.5, color="black", alpha=0.06, lw=0)
            for panel, column in enumerate(window.steps):
                _draw_steps(ax, window, column, {thread: places[panel, thread] for thread in threads}, threads)
            tops, bottoms = (0, len(threads) + gap), (len(threads), bottom)
            ax.vlines([window.at - 0.5] * 2, tops, bottoms, colors="black", alpha=0.55, lw=1, ls="--")
        down, end = len(threads) + 0.1, shown[-1].end
        for window in shown:
            # Beside its line if there is room for it on a phone.
            at, width = window.at, end * max(map(len, window.parting)) / _CHARACTERS
            x, side = (at - 0.4, "left") if at + width < end else (at - 0.6, "right") if at > width else (-0.5, "left")
            ax.text(x, down, "\n".join(window.parting), ha=side, va="top", fontsize=12.5)
            down += len(window.parting) * _LINE / _ROW
        names = [f"{_PANELS[panel]}: {thread}" for panel, thread in places]
        ax.set_yticks(list(places.values()), names, ha="left", va="top", weight="bold")
        ax.tick_params(axis="y", length=0, pad=0)
        ax.grid(visible=False)
        ax.set_xticks([(each.first + each.end - 1) / 2 for each in shown], [f"{each.time:.9g}" for each in shown])
        ax.set_xlabel(f"time (s); mark: a line of the node, with its number{left}", loc="right")
        ax.set_xlim(-0.8, shown[-1].end - 0.2)
        ax.set_ylim(bottom, 0)
    return ax


def both_orders(found: Orders, *, caption: str | None = None) -> Figure:
    """Draw two orders on one timeline, with the times at which they part, and :func:`orders` below that.

    One of both is left out if there is nothing to show in it. The figure is unknown to pyplot. Raises ValueError if
    there is nothing at all.
    """
    caption = "simulated" if caption is None else caption
    runs = {name: run for name, run in zip(_PANELS, (found.usual, found.here), strict=True) if run}
    ticks = {name: run.ticks for name, run in runs.items()}
    heights, is_timed = [], any(ticks.values())
    rows = [_row(name, group, None, ()) for name, group in ticks.items()]
    marks = [(round(each.time, 6), 0.0) for each in found.instants if each.deviations]
    parts = [_Row("where this order deviates", "", [], [], marks)]
    if is_timed:
        heights.append(_height([*rows, *parts]))
    if _windows(found.instants)[0]:
        heights.append(_orders_height(found))
    if not heights:
        raise ValueError("there are no ticks to plot, and no lines that differ")
    axes = pictures.new_column(heights)
    if is_timed:
        at = ", ".join(f"{time:g} s" for time, _ in marks)
        alt = f"{_describe(ticks, None, {})} This order deviates at {at}."
        ends = [run.seconds for run in runs.values()]
        _timeline(rows, None, len(rows), alt, caption, axes[0], ends, parts)
    if len(heights) > is_timed:
        orders(found, caption=caption, ax=axes[-1])
    return pictures.figure_of(axes[0])


class _Window(NamedTuple):
    """A part of an instant that is drawn: both orders' steps from the column ``first``; from ``at`` on they differ."""

    time: float
    first: int
    at: int
    steps: tuple[list[Step | None], list[Step | None]]
    parting: list[str]  # what was chosen here; or before, where that changed no step

    @property
    def end(self) -> int:
        return self.first + len(self.steps[0])


def _windows(instants: Sequence[Instant]) -> tuple[list[_Window], str]:
    """Choose the steps that are drawn; and say how many there are more at these times."""
    shown, parting, first, left = list[_Window](), list[str](), 0, 0
    for instant in instants:
        differs = instant.differs
        when = f"at {instant.time:.9g} s " if differs is None else ""
        parting += [f"{when}usually {usually},\nhere {here}" for usually, here in instant.deviations]
        if differs is None:
            continue
        start, most = max(differs - 2, 0), max(len(instant.usual), len(instant.here))
        end = min(most, start + _STEPS - first)
        if end <= differs:
            left += most
            continue
        columns = ([*column, *[None] * most] for column in (instant.usual, instant.here))
        usual, here = (column[start:end] for column in columns)
        more = [f"and {len(parting) - 2} more"] * (len(parting) > 2)
        said = [*parting[:2], *more] or ["the orders have parted before"]
        lines = [line for each in said for part in each.split("\n") for line in textwrap.wrap(part, _CHARACTERS)]
        shown.append(_Window(instant.time, first, first + differs - start, (usual, here), lines))
        parting = []
        left += most - (end - start)
        first += end - start
    return shown, f"\n{left:,} more step{'s' * (left != 1)} not drawn" if left else ""


def _orders_height(found: Orders) -> int:
    shown, left = _windows(found.instants)
    threads = {step.thread for window in shown for column in window.steps for step in column if step}
    lines = sum(len(window.parting) for window in shown)
    return round((2 * len(threads) + 0.2) * _ROW) + (lines + bool(left)) * _LINE + _AXIS


def _describe_orders(window: _Window) -> str:
    told = []
    for name, column in zip(_PANELS, window.steps, strict=True):
        groups = groupby(filter(None, column), lambda step: step.thread)
        steps = ", then ".join(f"{thread}: {', '.join(step.line for step in group)}" for thread, group in groups)
        told.append(f"lines in {name}: {steps or 'none'}")
    return f"At {window.time:.9g} s, {'; '.join(told)}. They part: {' '.join(window.parting)}."


def _draw_steps(
    ax: Axes, window: _Window, column: Sequence[Step | None], rows: Mapping[str, float], threads: Sequence[str]
) -> None:
    """Draw the steps of one order in one instant, and a bar for as long as the same thread goes on."""
    known = [(n, step) for n, step in enumerate(column, window.first) if step]
    for thread, group in groupby(known, lambda each: each[1].thread):
        steps, down, kind = list(group), rows[thread] + _TICKS / _ROW, threads.index(thread) % _KINDS
        left, right = steps[0][0] - 0.4, steps[-1][0] + 0.4
        ax.barh([down], [right - left], _BAR / _ROW, left, color=_COLOURS[kind], alpha=0.45)
        ax.plot([n for n, _ in steps], [down] * len(steps), ls="", c=_COLOURS[kind], **_MARKS[kind])
        for n, step in steps:
            weight = "bold" if n >= window.at else "normal"
            number = step.line.rpartition(":")[2]
            ax.annotate(number, (n, down), (0, -6), textcoords="offset points", ha="center", va="top", weight=weight)


def _ticks(one: One) -> Sequence[Tick]:
    return one.ticks if isinstance(one, Run) else one


def _groups(ticks: Ticks) -> dict[str, list[Tick]]:
    named = ticks if isinstance(ticks, Mapping) else by_source(_ticks(ticks))
    groups = {name: list(_ticks(group)) for name, group in named.items()}
    if not any(groups.values()):
        raise ValueError("there are no ticks to plot")
    for tick in (tick for group in groups.values() for tick in group):
        if not (math.isfinite(tick.expected) and math.isfinite(tick.real)):
            raise ValueError(f"a time that is not finite cannot be plotted: {tick}")
    return groups


def _coming(ticks: Ticks) -> dict[str, list[Tick]]:
    """The ticks that would have followed, of those that know it."""
    if isinstance(ticks, Run):
        return by_source(ticks.coming)
    named = ticks if isinstance(ticks, Mapping) else {}
    return {name: list(one.coming) if isinstance(one, Run) else [] for name, one in named.items()}


def _caption(caption: str | None, ticks: Ticks) -> str:
    """Return the caption given; if there is none, "simulated" if all of these are simulated Runs."""
    runs = ticks.values() if isinstance(ticks, Mapping) else [ticks]
    is_simulated = all(isinstance(run, Run) and run.runtime == "simulated" for run in runs)
    return caption if caption is not None else "simulated" if is_simulated else ""


def _describe(
    groups: Mapping[str, Sequence[Tick]],
    period: Period,
    coming: Mapping[str, Sequence[Tick]],
    position: str = "",
) -> str:
    words = []
    for name, group in groups.items():
        own = _period_of(name, period)
        gone = len(lost(group, own, coming.get(name, ()))) if own else 0
        words.append(describe_timeline(name, group) + (f" Lost ticks: {gone}." if own and (group or gone) else ""))
    return f"Timeline{position}. " + " ".join(words)


# --- a timeline: web/src/svg.js draws it in the same way from the same rows -------------------------------------------


class _Row(NamedTuple):
    """What a row of a timeline shows: all times in seconds, to the microsecond."""

    name: str
    words: str
    expected: list[float]
    lost: list[float]
    ticks: list[tuple[float, float]]  # when each came and how long it took; 0 where that is not known


def _rows(
    groups: Mapping[str, Sequence[Tick]],
    period: Period,
    coming: Mapping[str, Sequence[Tick]],
    worded: bool = False,
) -> list[_Row]:
    """Make the rows of a timeline, ``worded`` with a few words on each. One without ticks has the others' grid."""
    periods = {name: _period_of(name, period) for name in groups}
    for each in periods.values():
        if each is not None and not 0 < each < math.inf:
            raise ValueError(f"a period is above 0 s, not {each!r}")
    rows = [_row(name, group, periods[name], coming.get(name, ())) for name, group in groups.items()]
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


def _row(name: str, group: Sequence[Tick], period: float | None, coming: Sequence[Tick]) -> _Row:
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
    return _Row(name, "", times, [round(time, 6) for time in gone], ticks)


def _faults(ticks: Ticks, faults: Sequence[Mishap]) -> dict[str, Sequence[Mishap]]:
    """Return what faults did, by the names of the runs that know it; those that are given have none."""
    named = ticks if isinstance(ticks, Mapping) else {"": ticks}
    return {"": faults} | {name: run.faults for name, run in named.items() if isinstance(run, Run) and run.faults}


def _fault_rows(faults: Mapping[str, Sequence[Mishap]]) -> list[_Row]:
    rows = []
    for run, mishaps in faults.items():
        for name, group in mishaps_by_name(mishaps).items():
            marks = [(round(each.time, 6), round(max(each.by, 0.0), 6)) for each in group if math.isfinite(each.time)]
            marks = [(time, 0.0 if group[0].what == "set" else by) for time, by in marks]
            rows.append(_Row(f"{run}: {name}" if run else name, "", [], [], marks))
    return rows


def _times(rows: Iterable[_Row]) -> Iterator[float]:
    for row in rows:
        yield from (*row.expected, *(real + duration for real, duration in row.ticks))


def _title(period: Period) -> str:
    return "time (s); line: expected, mark: real" + (", cross: lost" if period else "")


def _timeline(
    rows: Sequence[_Row],
    period: Period,
    kinds: int,
    alt: str,
    caption: str,
    ax: Axes | None,
    times: Iterable[float],
    faults: Sequence[_Row] = (),
) -> Axes:
    """Draw the rows, and then those of ``faults``.

    The axis of time begins with the run and has room for these ``times``, too.
    """
    known = [*(number % kinds % _KINDS for number in range(len(rows))), *[_FAULT] * len(faults)]
    rows = [*rows, *faults]
    with pictures.drawing(ax, alt, caption, _height(rows)) as ax:
        drawn = sum(_draw_row(ax, number, row, known[number]) for number, row in enumerate(rows))
        ax.set_yticks(range(len(rows)), [row.name for row in rows], ha="left", va="top", weight="bold")
        ax.tick_params(axis="y", length=0, pad=0)
        ax.grid(visible=False)
        ax.set_xlabel(_title(period) + _said(drawn, sum(len(row.ticks) for row in rows)), loc="right")
        ax.update_datalim([(time, 0) for time in (0.0, *times) if math.isfinite(time)])
        ax.use_sticky_edges = False
        ax.margins(x=_MARGIN)
        ax.set_ylim(len(rows), 0)
        ax.locator_params("x", nbins=7, steps=[1, 2, 5, 10])
        ax.xaxis.set_major_formatter("{x:.9g}")
    return ax


def _height(rows: Sequence[_Row]) -> int:
    """Return the height (px) of a timeline's own figure."""
    return _ROW * len(rows) + _AXIS + (16 if any(len(row.ticks) > _MANY for row in rows) else 0)


def _draw_row(ax: Axes, number: int, row: _Row, kind: int) -> int:
    """Draw a row, 1 high, and return how many marks it has."""
    middle = number + _TICKS / _ROW
    lanes, height = _lanes(row.ticks)
    few = _few([real for real, _ in row.ticks], [duration for _, duration in row.ticks])
    bars = [(middle + lanes[n], *row.ticks[n]) for n in few if row.ticks[n][1]]
    lines, crosses = ([times[n] for n in _few(times, [0.0] * len(times))] for times in (row.expected, row.lost))
    reach = _REACH / _ROW
    ax.vlines(lines, middle - reach, middle + reach, colors="black", alpha=0.55, lw=1, zorder=0.8)
    if bars:
        down, left, width = zip(*bars, strict=True)
        ax.barh(down, width, height, left, color=_COLOURS[kind], alpha=0.45)
    ax.plot(crosses, [middle] * len(crosses), "x", c="black", ms=10)
    # Ticks at the same time are drawn one above the other, as far as there is room.
    above, before, places = 0, (-math.inf, 0.0), []
    for n in few:
        place = row.ticks[n][0], lanes[n]
        above = min(above + 1, _MOST_ABOVE) if place[0] - before[0] < 1e-3 and place[1] == before[1] else 0
        places.append((place[0], middle + place[1] - above * _ABOVE / _ROW))
        before = place
    ax.plot(*zip(*places, strict=True) if places else ((), ()), ls="", c=_COLOURS[kind], **_MARKS[kind])
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
    return [(lane - (len(ends) - 1) / 2) * pitch / _ROW for lane in taken], max(min(_BAR, pitch - 1), 0.5) / _ROW


# --- what the plots have in common ------------------------------------------------------------------------------------


def _few(across: Sequence[float], up: Sequence[float]) -> list[int]:
    """Return which points to draw: all, or, if they are many, the lowest and the highest in each column."""
    if len(across) <= _MANY:
        return list(range(len(across)))
    first = min(across)
    width = (max(across) - first) / _COLUMNS or 1.0
    columns: dict[int, tuple[int, int]] = {}
    for n, (x, y) in enumerate(zip(across, up, strict=True)):
        low, high = columns.setdefault(int((x - first) / width), (n, n))
        columns[int((x - first) / width)] = (n if y < up[low] else low, n if y > up[high] else high)
    return sorted({n for pair in columns.values() for n in pair})


def _said(drawn: int, of: int) -> str:
    return f"\n{drawn:,} of {of:,} ticks drawn" if drawn < of else ""


def _name(ax: Axes, groups: Collection[str]) -> None:
    if len(groups) > 1:
        ax.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=len(groups), markerscale=1.6)
