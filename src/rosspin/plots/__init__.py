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
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
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
from ..results.ticks import Mishap, Run, Tick
from . import pictures

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Movable", "compare", "lateness", "overview", "period_histogram", "picture", "timeline", "with_handle"]

# The ticks of a run; and what a plot shows: such ticks, named by their source, or several by the names to give them.
One = Run | Sequence[Tick]
Ticks = One | Mapping[str, One]

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
    period: float | None = None,
    kinds: int = _KINDS,
    end: float = 0.0,
    *,
    faults: Sequence[Mishap] = (),
    caption: str | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Plot when each tick was expected and when it came, in seconds; a bar shows how long it took.

    With ``period`` (s, above 0), there is a line for every period, even where no tick came, and a cross for every lost
    tick, in a simulated Run up to its end. The rows take turns with up to three ``kinds``, each with its own mark and
    colour. Calls that overlap have a lane each. The axis goes to the last tick, or to the ``end`` of the run (s), which
    a Run knows. What ``faults`` did, which a Run knows, too, has rows of its own, with triangles; a bar shows by how
    much something came late.
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
    period: float | None = None,
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
    period: float | None,
    coming: Mapping[str, Sequence[Tick]],
    position: str = "",
) -> str:
    words = []
    for name, group in groups.items():
        gone = len(lost(group, period, coming.get(name, ()))) if period else 0
        words.append(describe_timeline(name, group) + (f" Lost ticks: {gone}." if period and (group or gone) else ""))
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
    period: float | None,
    coming: Mapping[str, Sequence[Tick]],
    worded: bool = False,
) -> list[_Row]:
    """Make the rows of a timeline, ``worded`` with a few words on each. One without ticks has the others' grid."""
    if period is not None and not 0 < period < math.inf:
        raise ValueError(f"a period is above 0 s, not {period!r}")
    rows = [_row(name, group, period, coming.get(name, ())) for name, group in groups.items()]
    grid = max((row.expected for row in rows), key=len)
    due = len(grid)
    for number, (name, group) in enumerate(groups.items()):
        words = (
            (verdict(group, period, due, coming.get(name, ())) if period else describe_pace(group)) if worded else ""
        )
        expected = rows[number].expected or (grid if period else [])
        rows[number] = rows[number]._replace(words=words, expected=expected)
    return rows


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


def _title(period: float | None) -> str:
    return "time (s); line: expected, mark: real" + (", cross: lost" if period else "")


def _timeline(
    rows: Sequence[_Row],
    period: float | None,
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
