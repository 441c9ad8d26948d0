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
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..measures import by_source, describe_faults, describe_lateness, describe_periods, periods
from ..results.ticks import FaultEvent, Run, Tick
from ..vehicle.drives import NODE, Drive
from . import pictures
from .driven import ROAD, draw_off, draw_way
from .layout import COLUMNS, KINDS, to_draw
from .rows import (
    COLOURS,
    MARKS,
    Period,
    describe,
    draw_rows,
    fault_rows,
    height_of,
    make_rows,
    said_if_fewer,
    times_of,
    title,
)
from .two_orders import both_orders, orders

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = [
    *("Movable", "compare", "drive", "lateness", "overview", "period_histogram", "picture", "timeline", "with_handle"),
    "both_orders",
    "orders",
]

# The ticks of a run; and what a plot shows: such ticks, named by their source, or several by the names to give them.
One = Run | Sequence[Tick]
Ticks = One | Mapping[str, One]

_BINS = 40
_PLOT = 220  # px, of the plots below a timeline


def timeline(
    ticks: Ticks,
    period: Period = None,
    kinds: int = KINDS,
    end: float = 0.0,
    *,
    faults: Sequence[FaultEvent] = (),
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
    rows = make_rows(groups, period, coming)
    runs = ticks.values() if isinstance(ticks, Mapping) else [ticks]
    ends = [end, *(run.seconds for run in runs if isinstance(run, Run))]
    went_wrong = _faults(ticks, faults)
    alt = " ".join([describe(groups, period, coming), *map(describe_faults, filter(None, went_wrong.values()))])
    return draw_rows(rows, period, kinds, alt, _caption(caption, ticks), ax, ends, fault_rows(went_wrong))


def picture(
    ticks: Ticks,
    period: Period = None,
    kinds: int = KINDS,
    end: float = 0.0,
    *,
    faults: Sequence[FaultEvent] = (),
    caption: str | None = None,
) -> Figure:
    """Draw a :func:`timeline` in a figure that pyplot does not know: no window opens, and no one has to close it."""
    ax = pictures.new_axes(height_of([*make_rows(_groups(ticks), None, {}), *fault_rows(_faults(ticks, faults))]))
    return pictures.figure_of(timeline(ticks, period, kinds, end, faults=faults, caption=caption, ax=ax))


def overview(ticks: Ticks, *, caption: str | None = None) -> Figure:
    """Draw a :func:`timeline`, the :func:`lateness` and a :func:`period_histogram` in a figure unknown to pyplot."""
    heights = [height_of(make_rows(_groups(ticks), None, {})), _PLOT, _PLOT]
    axes = pictures.new_column(heights)
    for draw, ax in zip((timeline, lateness, period_histogram), axes, strict=True):
        draw(ticks, caption=caption, ax=ax)
        if legend := ax.get_legend():  # the rows of the timeline name the colours, and need less room
            legend.remove()
    return pictures.figure_of(axes[0])


def drive(run: Run, *, caption: str | None = None) -> Figure:
    """Draw what a vehicle did, from a run with a node of :mod:`rosspin.vehicle`, in a figure unknown to pyplot.

    From above: its way, how far off its line it was, and a :func:`timeline` of the other nodes' ticks and of the
    commands, by their senders. Raises ValueError if there is no vehicle in the run.
    """
    groups = {name: group for name, group in by_source(run.ticks).items() if not name.startswith(f"{NODE} ")}
    return drive_beside(Drive.of(run.messages), groups, run.seconds, _caption(caption, run))


def drive_beside(shown: Drive, ticks: Mapping[str, Sequence[Tick]], end: float, caption: str) -> Figure:
    """Draw a drive up to its ``end`` (s), next to these ticks, as :func:`drive` does."""
    if not shown.spots:
        raise ValueError("no vehicle says where it is in this run: rosspin.simulate([my_node, vehicle], ...)")
    groups = dict(ticks)
    for sender in dict.fromkeys(command.node for command in shown.commands):
        times = [command.time for command in shown.commands if command.node == sender]
        groups[f"{sender} /cmd_vel"] = [Tick(sender, number, time, time, 0.0) for number, time in enumerate(times, 1)]
    rows = make_rows(groups, None, {}) if groups else []
    axes = pictures.new_column([ROAD, 0.7 * _PLOT, *([height_of(rows)] if rows else [])])
    draw_way(shown, caption, axes[0])
    draw_off(shown, caption, axes[1])
    if rows:
        timeline(groups, end=end, caption=caption, ax=axes[2])
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
            few = to_draw(across, up)
            drawn += len(few)
            mark = MARKS[row % KINDS] | {"ms": 5 if len(few) <= COLUMNS else 3, "mew": row % KINDS // 2}
            colour = COLOURS[row % KINDS]
            ax.plot([across[n] for n in few], [up[n] for n in few], ls="", c=colour, label=name, **mark)
        ax.set_xlabel("time expected (s)" + said_if_fewer(drawn, sum(map(len, groups.values()))), loc="right")
        ax.set_ylabel("lateness (ms)")
        _name(ax, groups)
    return ax


def period_histogram(ticks: Ticks, *, caption: str | None = None, ax: Axes | None = None) -> Axes:
    """Plot how often each period (ms) between two ticks occurred. The bars of several groups are side by side."""
    groups = _groups(ticks)
    words = [f"{name}: {describe_periods(group)}" for name, group in groups.items()]
    times = [[period * 1e3 for period in periods(group)] for group in groups.values()]
    found = [time for group in times for time in group]
    first, last = min(found, default=0.0), max(found, default=1.0)
    if last - first <= 1e-6 * abs(last):  # differences by rounding alone have no bins
        first, last = first - 0.05 * (abs(first) or 1.0), last + 0.05 * (abs(last) or 1.0)
    with pictures.drawing(ax, "Distribution of periods. " + " ".join(words), _caption(caption, ticks)) as ax:
        colours = [COLOURS[row % KINDS] for row in range(len(groups))]
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
    kinds: int = KINDS,
    *,
    caption: str | None = None,
) -> Movable:
    """Plot a timeline that the reader of a page moves: ``runs`` are the ticks for each position of a handle.

    ``label`` and ``unit`` say what the position is. ``at`` is the position shown first, and the only one in print or
    without the page's script, which draws the others. ``period`` and ``kinds`` are as in :func:`timeline`; with a
    period, each row says whether the grid was kept and how many ticks were lost. ``sets`` names the variable that has
    the position as its value in the code next to the plot.

    Raises ValueError if ``at`` is no position, or if there is one without ticks.
    """
    if at not in runs:
        raise ValueError(f"{at!r} is no position of the handle: they are {', '.join(map(repr, runs))}")
    positions = {value: _groups(ticks) for value, ticks in runs.items()}
    coming = {value: _coming(ticks) for value, ticks in runs.items()}
    rows = {value: make_rows(groups, period, coming[value], worded=True) for value, groups in positions.items()}
    times = [0.0, *(time for group in rows.values() for time in times_of(group))]
    said = {value: html.escape(f"{value:g} {unit}") for value in runs}
    alts = {
        value: describe(groups, period, coming[value], f", {label}: {value:g} {unit}")
        for value, groups in positions.items()
    }
    data = {
        "first": min(times),
        "span": max(times) - min(times) or 1.0,
        "kinds": kinds,
        "title": title(period),
        "sets": sets,
        "positions": [[f"{value:g}", f"{value:g} {unit}", alts[value], rows[value]] for value in runs],
    }
    handle = (
        f'<label class="rosspin-handle" hidden>{html.escape(label)} ({html.escape(unit)}) '
        f'<b aria-hidden="true">{said[at]}</b> <input type="range" min="0" max="{len(runs) - 1}" step="1" '
        f'value="{list(runs).index(at)}" autocomplete="off" aria-valuetext="{said[at]}"></label>'
    )
    ax = pictures.new_axes(height_of(rows[at]))
    draw_rows(rows[at], period, kinds, alts[at], _caption(caption, runs[at]), ax, times)
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
    """Return the ticks that would have followed, of those that know it."""
    if isinstance(ticks, Run):
        return by_source(ticks.coming)
    named = ticks if isinstance(ticks, Mapping) else {}
    return {name: list(one.coming) if isinstance(one, Run) else [] for name, one in named.items()}


def _caption(caption: str | None, ticks: Ticks) -> str:
    """Return the caption given; if there is none, "simulated" if all of these are simulated Runs."""
    runs = ticks.values() if isinstance(ticks, Mapping) else [ticks]
    is_simulated = all(isinstance(run, Run) and run.runtime == "simulated" for run in runs)
    return caption if caption is not None else "simulated" if is_simulated else ""


def _faults(ticks: Ticks, faults: Sequence[FaultEvent]) -> dict[str, Sequence[FaultEvent]]:
    """Return what faults did, by the names of the runs that know it; those that are given have none."""
    named = ticks if isinstance(ticks, Mapping) else {"": ticks}
    return {"": faults} | {name: run.faults for name, run in named.items() if isinstance(run, Run) and run.faults}


def _name(ax: Axes, groups: Collection[str]) -> None:
    if len(groups) > 1:
        ax.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=len(groups), markerscale=1.6)
