"""Plot ticks as vector graphics that adapt to the page around them: light or dark, wide or narrow.

Across, a plot measures in percent of the width that it is given; down, in pixels. So it fills its place, and its text
keeps its size.
"""

from __future__ import annotations

import html
import json
import math
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple

from .measures import (
    by_source,
    describe_lateness,
    describe_pace,
    describe_periods,
    describe_timeline,
    lost,
    periods,
    verdict,
)
from .ticks import Tick

__all__ = ["Figure", "lateness", "period_histogram", "timeline", "with_handle"]

# Ticks by the name they are to have in the plot, or just ticks, which go by their source.
Ticks = Sequence[Tick] | Mapping[str, Sequence[Tick]]

# Blue, vermilion and green of Okabe and Ito's colour-blind-safe set: at least 3:1 on white and on near-black alike.
_COLOURS = ("#0072b2", "#d55e00", "#009e73")

_FONT = 13
_ROW = 54  # a row of a timeline: its name, and below that its ticks
_TICKS = 34  # how far the middle of the ticks is below the top of their row
_REACH = 13  # how far a line for an expected tick goes up and down from there
_BAR = 10
_MOST_ABOVE = 2  # so many ticks stand above one that came at the same time
_AXIS = 42  # the height of an axis with its numbers and its title
_LEFT, _RIGHT = 8, 14  # room for what goes beyond the plot: half a mark, half a number
_NUMBERS = 44  # room for the numbers of a vertical axis
_HEIGHT = 150  # of a plot with a vertical axis, without the other axis
_WIDTH = 640  # of a saved plot

_STANDALONE = (
    "<style>svg{color:#1b1b1b;background:#fff}"
    "@media(prefers-color-scheme:dark){svg{color:#eee;background:#14181e}}</style>"
)


@dataclass(frozen=True)
class Figure:
    """A plot, which a notebook displays: ``svg`` is the picture, ``alt`` describes it in words."""

    drawing: str
    height: int
    left: int
    alt: str
    caption: str = ""
    handle: str = ""
    positions: str = ""

    @property
    def svg(self) -> str:
        """The picture, for a page: as wide as the text around it."""
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{html.escape(self.alt)}" '
            f'width="100%" height="{self.height}" style="{_TEXT}; display: block; overflow: visible; '
            f'box-sizing: border-box; padding: 0 {_RIGHT}px 0 {self.left}px">{self.drawing}</svg>'
        )

    def captioned(self, caption: str) -> Figure:
        """The same plot with a caption, which says where the data come from."""
        return replace(self, caption=caption)

    def _repr_html_(self) -> str:
        caption = f"<figcaption>{html.escape(self.caption)}</figcaption>" if self.caption else ""
        data = f" data-positions='{self.positions}'" if self.positions else ""
        return f'<figure class="rosspin-plot"{data}>{self.handle}{self.svg}{caption}</figure>'

    def __repr__(self) -> str:
        return f"<Figure: {self.alt}>"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Save the picture as a standalone SVG file, light or dark as the viewer prefers."""
        width = self.left + _WIDTH + _RIGHT
        svg = (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{html.escape(self.alt)}" '
            f'width="{width}" height="{self.height}" viewBox="0 0 {width} {self.height}" '
            f'style="{_TEXT.replace("inherit", "system-ui, sans-serif")}">{_STANDALONE}'
            f'<svg x="{self.left}" width="{_WIDTH}" overflow="visible">{self.drawing}</svg></svg>'
        )
        Path(path).write_text(f'<?xml version="1.0" encoding="utf-8"?>\n{svg}\n', encoding="utf-8")


_TEXT = f"font-family: inherit; font-size: {_FONT}px; fill: currentColor"


def timeline(ticks: Ticks, period: float | None = None, kinds: int = len(_COLOURS), end: float = 0.0) -> Figure:
    """Plot when each tick was expected and when it came, in seconds; a bar shows how long it took.

    With ``period`` (s), there is a line for every period, even where no tick came, and a cross for every lost tick.
    The rows are of up to three ``kinds`` in turn, each of which has a mark and a colour of its own. The axis goes to
    the last tick, or on to the ``end`` of the run (s).
    """
    groups = _groups(ticks)
    rows = _rows(groups, period)
    return _timeline(rows, _scale(rows, end), period, kinds, _describe(groups, period))


def with_handle(
    label: str,
    unit: str,
    runs: Mapping[float, Ticks],
    at: float,
    period: float | None = None,
    sets: str = "",
    kinds: int = len(_COLOURS),
) -> Figure:
    """Plot a timeline that the reader of a page moves: ``runs`` are the ticks for each position of a handle.

    ``label`` and ``unit`` say what the position is, and ``at`` is the one shown first, also in print and wherever the
    page's script is missing. ``period`` and ``kinds`` are those of :func:`timeline`; with a period, each row says
    whether the grid was kept and how many ticks were lost. ``sets`` names the variable that the position is in code
    which stands beside the plot.

    Raises ValueError if ``at`` is no position, or if there is one without ticks.
    """
    if at not in runs:
        raise ValueError(f"{at!r} is no position of the handle: they are {', '.join(map(repr, runs))}")
    positions = {value: _groups(ticks) for value, ticks in runs.items()}
    rows = {value: _rows(groups, period, worded=True) for value, groups in positions.items()}
    scale = _scale([row for group in rows.values() for row in group])
    said = {value: f"{value:g} {unit}" for value in runs}
    alts = {value: _describe(groups, period, f", {label}: {said[value]}") for value, groups in positions.items()}
    data = {
        "first": scale.first,
        "span": scale.span,
        "kinds": kinds,
        "sets": sets,
        "positions": [[f"{value:g}", said[value], alts[value], rows[value]] for value in runs],
    }
    handle = (
        f'<label class="rosspin-handle" hidden>{html.escape(label)} ({html.escape(unit)}) '
        f'<b aria-hidden="true">{html.escape(said[at])}</b> '
        f'<input type="range" min="0" max="{len(runs) - 1}" step="1" value="{list(runs).index(at)}" '
        f'autocomplete="off" aria-valuetext="{html.escape(said[at])}"></label>'
    )
    return replace(
        _timeline(rows[at], scale, period, kinds, alts[at]),
        handle=handle,
        positions=html.escape(json.dumps(data, separators=(",", ":"), ensure_ascii=False), quote=False).replace(
            "'", "&#39;"
        ),
    )


def lateness(ticks: Ticks) -> Figure:
    """Plot how late each tick was (ms) against the time at which it was expected (s)."""
    groups = _groups(ticks)
    all_ticks = [tick for group in groups.values() for tick in group]
    across = _Scale.of(tick.expected for tick in all_ticks)
    late = _Scale.of((0, *(tick.lateness * 1e3 for tick in all_ticks)))
    marks = [
        _mark(row, across(tick.expected), late.down(tick.lateness * 1e3), 2.5 if len(group) <= 200 else 1.5)
        for row, group in enumerate(groups.values())
        for tick in group
    ]
    words = [f"{name}: {describe_lateness(group)}" for name, group in groups.items()]
    alt = "Lateness of each tick. " + " ".join(words)
    return _upright(groups, marks, across, "time expected (s)", late, "lateness (ms)", alt)


def period_histogram(ticks: Ticks) -> Figure:
    """Plot how often each period (ms) between two ticks occurred."""
    groups = _groups(ticks)
    times = [[period * 1e3 for period in periods(group)] for group in groups.values()]
    across = _Scale.of(time for group in times for time in group)
    counts = [_count(group, across) for group in times]
    high = _Scale.of((0, *(count for group in counts for count in group)), whole=True)
    # Those of several groups stand side by side.
    share = 100 / _BINS / len(groups)
    bars = [
        f'<rect x="{_percent((place * len(groups) + row) * share)}" y="{_number(high.down(count))}" '
        f'width="{_percent(share)}" height="{_number(_HEIGHT - high.down(count))}" fill="{_colour(row)}"/>'
        for row, group in enumerate(counts)
        for place, count in enumerate(group)
        if count
    ]
    words = [f"{name}: {describe_periods(group)}" for name, group in groups.items()]
    alt = "Distribution of periods. " + " ".join(words)
    return _upright(groups, bars, across, "period (ms)", high, "number of periods", alt)


_BINS = 40


def _count(values: Iterable[float], scale: _Scale) -> list[int]:
    counts = [0] * _BINS
    for value in values:
        counts[min(int((value - scale.first) / scale.span * _BINS), _BINS - 1)] += 1
    return counts


def _groups(ticks: Ticks) -> dict[str, list[Tick]]:
    named = ticks if isinstance(ticks, Mapping) else by_source(ticks)
    groups = {name: list(group) for name, group in named.items()}
    if not any(groups.values()):
        raise ValueError("there are no ticks to plot")
    return groups


def _describe(groups: Mapping[str, Sequence[Tick]], period: float | None, position: str = "") -> str:
    words = [
        describe_timeline(name, group) + (f" Lost ticks: {len(lost(group, period))}." if period and group else "")
        for name, group in groups.items()
    ]
    return f"Timeline{position}. " + " ".join(words)


# --- a timeline, which web/src/svg.js draws in the same way ----------------------------------------------------------


class _Row(NamedTuple):
    """What a row of a timeline shows: all times in seconds, to the microsecond."""

    name: str
    words: str
    expected: list[float]
    lost: list[float]
    ticks: list[tuple[float, float]]  # when each came and how long it took; 0 where that is not known


def _rows(groups: Mapping[str, Sequence[Tick]], period: float | None, worded: bool = False) -> list[_Row]:
    """The rows of a timeline; ``worded``: with a few words on each. One without ticks has the grid of the others."""
    rows = [_row(name, group, period) for name, group in groups.items()]
    grid = max((row.expected for row in rows), key=len)
    due = len(grid)
    for number, group in enumerate(groups.values()):
        words = (verdict(group, period, due) if period else describe_pace(group)) if worded else ""
        expected = rows[number].expected or (grid if period else [])
        rows[number] = rows[number]._replace(words=words, expected=expected)
    return rows


def _row(name: str, group: Sequence[Tick], period: float | None) -> _Row:
    gone = lost(group, period) if period else []
    expected = {tick.expected for tick in group if not period} | set(gone)
    if period and group:
        last = max(group[-1].real, group[0].expected)
        steps = int((last - group[0].expected) / period + 1e-3) + 1
        expected |= {group[0].expected + step * period for step in range(steps)}
    times = sorted({round(time, 6) for time in expected})
    ticks = [(round(tick.real, 6), round(tick.duration, 6) if tick.duration > 0 else 0.0) for tick in group]
    return _Row(name, "", times, [round(time, 6) for time in gone], ticks)


def _scale(rows: Iterable[_Row], end: float = 0.0) -> _Scale:
    """From the beginning of the run to the end of the last tick, or on to a later ``end`` (s)."""
    times = (time for row in rows for time in (*row.expected, *(real + duration for real, duration in row.ticks)))
    return _Scale.of((0, end, *times))


def _timeline(rows: Sequence[_Row], scale: _Scale, period: float | None, kinds: int, alt: str) -> Figure:
    drawn = "".join(f"<g>{''.join(_draw_row(number, row, scale, kinds))}</g>" for number, row in enumerate(rows))
    height = _ROW * len(rows)
    title = "time (s); line: expected, mark: real" + (", cross: lost" if period else "")
    return Figure(drawn + _axis(scale, height, title), height + _AXIS, _LEFT, alt)


def _draw_row(number: int, row: _Row, scale: _Scale, kinds: int) -> Iterator[str]:
    top, kind = _ROW * number, number % kinds
    y = top + _TICKS
    lanes, height = _lanes(row.ticks)
    words = f" {html.escape(row.words)}" if row.words else ""
    name = html.escape(row.name)
    yield f'<text x="{-_LEFT}" y="{top + 14}"><tspan font-weight="600">{name}</tspan>{words}</text>'
    for time in row.expected:
        x = scale(time)
        ends = f'x1="{x}" x2="{x}" y1="{y - _REACH}" y2="{y + _REACH}"'
        yield f'<line {ends} stroke="currentColor" stroke-opacity="0.55"/>'
    for (real, duration), lane in zip(row.ticks, lanes, strict=True):
        if duration:
            place = f'x="{scale(real)}" y="{_number(y + lane - height / 2)}"'
            size = f'width="{_percent(100 * duration / scale.span)}" height="{_number(height)}"'
            yield f'<rect {place} {size} fill="{_colour(kind)}" fill-opacity="0.45"/>'
    for time in row.lost:
        yield (
            f'<svg x="{scale(time)}" y="{y}" overflow="visible">'
            '<path d="M-5 -5L5 5M-5 5L5 -5" stroke="currentColor" stroke-width="2"/></svg>'
        )
    # Ticks at the same time are drawn one above the other, as far as there is room.
    above, before = 0, (-math.inf, 0.0)
    for (real, _), lane in zip(row.ticks, lanes, strict=True):
        above = min(above + 1, _MOST_ABOVE) if real - before[0] < 1e-3 and lane == before[1] else 0
        before = real, lane
        yield _mark(kind, scale(real), y + lane - 10 * above, 4)


def _lanes(ticks: Sequence[tuple[float, float]]) -> tuple[list[float], float]:
    """How far down the calls of a row are, and the height of their bars: calls that overlap get a lane each."""
    ends: list[float] = []  # of the last call in each lane
    taken = []
    for real, duration in ticks:
        lane = next((lane for lane, end in enumerate(ends) if end < real + 1e-3), len(ends))
        ends[lane : lane + 1] = [real + duration]
        taken.append(lane)
    pitch = 2 * _REACH / max(len(ends), 1)
    return [(lane - (len(ends) - 1) / 2) * pitch for lane in taken], min(_BAR, pitch - 1)


# --- what the plots are made of ---------------------------------------------------------------------------------------


class _Scale(NamedTuple):
    """An axis from ``first`` on, ``span`` long."""

    first: float
    span: float

    @staticmethod
    def of(values: Iterable[float], whole: bool = False) -> _Scale:
        """The scale of all of these; ``whole``: of whole numbers."""
        found = list(values) or [0.0]
        first, last = min(found), max(found)
        span = last - first or (1 if whole else abs(first) * 0.1 or 1.0)
        return _Scale(first, span)

    def __call__(self, value: float) -> str:
        """How far a value is to the right."""
        return _percent(100 * (value - self.first) / self.span)

    def down(self, value: float) -> float:
        """How far a value is below the top of a vertical axis, in pixels."""
        return _HEIGHT * (1 - (value - self.first) / self.span)

    def numbers(self, most: int, whole: bool = False) -> Iterator[float]:
        """Round numbers to write at the axis: as many as there may be at steps of 1, 2 or 5 times a power of ten."""
        power = 10.0 ** math.floor(math.log10(self.span / most))
        step = next(factor * power for factor in (1, 2, 5, 10) if self.span / (factor * power) <= most)
        step = max(step, 1) if whole else step
        lowest, highest = self.first / step - 1e-9, (self.first + self.span) / step + 1e-9
        yield from (number * step for number in range(math.ceil(lowest), math.floor(highest) + 1))


def _number(value: float) -> str:
    return f"{math.floor(value * 1e3 + 0.5) / 1e3:g}"


def _percent(share: float) -> str:
    return f"{_number(share)}%"


def _colour(row: int) -> str:
    return _COLOURS[row % len(_COLOURS)]


def _mark(row: int, x: str, y: float, size: float) -> str:
    """A mark for a tick: a dot in the first row, a square in the second, a ring in the third."""
    at, colour = f'cy="{_number(y)}"', _colour(row)
    match row % len(_COLOURS):
        case 1:
            side = _number(2 * size)
            return (
                f'<rect x="{x}" y="{_number(y - size)}" width="{side}" height="{side}" '
                f'transform="translate({_number(-size)})" fill="{colour}"/>'
            )
        case 2:
            return f'<circle cx="{x}" {at} r="{_number(size - 0.5)}" fill="none" stroke="{colour}" stroke-width="2"/>'
    return f'<circle cx="{x}" {at} r="{_number(size)}" fill="{colour}"/>'


def _axis(scale: _Scale, top: int, title: str) -> str:
    """A horizontal axis."""
    ends = f'x1="0" x2="100%" y1="{top + 0.5}" y2="{top + 0.5}"'
    parts = [f'<line {ends} stroke="currentColor"/>']
    for number in scale.numbers(7):
        x = scale(number)
        parts.append(f'<line x1="{x}" x2="{x}" y1="{top}" y2="{top + 4}" stroke="currentColor"/>')
        parts.append(f'<text x="{x}" y="{top + 18}" text-anchor="middle">{number:.6g}</text>')
    parts.append(f'<text x="100%" dx="{_RIGHT}" y="{top + 36}" text-anchor="end">{title}</text>')
    return "".join(parts)


def _upright(
    groups: Mapping[str, Any],
    marks: Sequence[str],
    across: _Scale,
    title: str,
    up: _Scale,
    named: str,
    alt: str,
) -> Figure:
    """A plot with two axes; above it stand what goes upwards and, if there are several, the groups' names."""
    names = list(groups) if len(groups) > 1 else []
    head = 26 + 18 * len(names)
    left = -_NUMBERS
    parts = [f'<text x="{left}" y="14">{named}</text>']
    for row, name in enumerate(names):
        y = 32 + 18 * row
        parts.append(_mark(row, str(left + 6), y - 4, 4))
        parts.append(f'<text x="{left + 18}" y="{y}">{html.escape(name)}</text>')
    body = []
    for number in up.numbers(5, whole=named.startswith("number")):
        at = _number(up.down(number))
        body.append(f'<line x1="0" x2="100%" y1="{at}" y2="{at}" stroke="currentColor" stroke-opacity="0.25"/>')
        body.append(f'<text x="-6" y="{at}" dy="4" text-anchor="end">{number:.6g}</text>')
    drawn = "".join((*body, *marks, _axis(across, _HEIGHT + 6, title)))
    parts.append(f'<svg y="{head}" overflow="visible">{drawn}</svg>')
    return Figure("".join(parts), head + _HEIGHT + 6 + _AXIS, _NUMBERS, alt)
