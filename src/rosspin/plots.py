"""Plot ticks as vector graphics that adapt to the page around them: light or dark, wide or narrow."""

from __future__ import annotations

import hashlib
import html
import io
import os
import re
from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from itertools import pairwise
from pathlib import Path
from typing import Any, ParamSpec

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from matplotlib.ticker import MaxNLocator

from .measures import by_source, describe_lateness, describe_periods, describe_timeline, lost, periods
from .ticks import Tick

__all__ = ["Figure", "lateness", "period_histogram", "timeline"]

P = ParamSpec("P")

# Ticks by the name they are to have in the plot, or just ticks, which go by their source.
Ticks = Sequence[Tick] | Mapping[str, Sequence[Tick]]

# Blue, vermilion and green of Okabe and Ito's colour-blind-safe set: at least 3:1 on white and on near-black alike.
_COLOURS = ("#0072b2", "#d55e00", "#009e73")
_MARKERS = ("o", "s", "^")

# Stands for the colour of the text around the plot until the SVG is written.
_TEXT = "#010203"

_STYLE: Any = {
    "axes.edgecolor": _TEXT,
    "axes.labelcolor": _TEXT,
    "axes.linewidth": 0.6,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "font.size": 10.0,
    "legend.frameon": False,
    "legend.handlelength": 1.2,
    "svg.fonttype": "none",
    "text.color": _TEXT,
    "xtick.color": _TEXT,
    "ytick.color": _TEXT,
}
_WIDTH = 4.6  # inches: narrow, so that it need not shrink much on a phone

_STANDALONE = (
    "<style>svg{color:#1b1b1b;background:#fff}"
    "@media(prefers-color-scheme:dark){svg{color:#eee;background:#14181e}}</style>"
)


class Figure:
    """A plot, which a notebook displays: ``svg`` is the picture, ``alt`` describes it in words."""

    def __init__(self, svg: str, alt: str, caption: str = "") -> None:
        self.svg = svg
        self.alt = alt
        self.caption = caption

    def captioned(self, caption: str) -> Figure:
        """The same plot with a caption, which says where the data come from."""
        return Figure(self.svg, self.alt, caption)

    def _repr_html_(self) -> str:
        caption = f"<figcaption>{html.escape(self.caption)}</figcaption>" if self.caption else ""
        return f'<figure class="rosspin-plot">{self.svg}{caption}</figure>'

    def __repr__(self) -> str:
        return f"<Figure: {self.alt}>"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Save the picture as a standalone SVG file, light or dark as the viewer prefers."""
        svg = self.svg.replace(">", f">{_STANDALONE}", 1)
        svg = svg.replace("font-family: inherit", "font-family: system-ui, sans-serif")
        Path(path).write_text(f'<?xml version="1.0" encoding="utf-8"?>\n{svg}\n', encoding="utf-8")


def _styled(plot: Callable[P, Figure]) -> Callable[P, Figure]:
    @wraps(plot)
    def styled(*args: P.args, **kwargs: P.kwargs) -> Figure:
        with matplotlib.rc_context(_STYLE):
            return plot(*args, **kwargs)

    return styled


@_styled
def timeline(ticks: Ticks, period: float | None = None) -> Figure:
    """Plot when each tick was expected and when it came, in seconds; a bar shows how long it took.

    With ``period`` (s), there is a line for every period, even where no tick came, and a cross for every lost tick.
    """
    groups = _groups(ticks)
    canvas, axes = _canvas(0.95 + 0.4 * len(groups))
    words = []
    for row, (name, group) in enumerate(groups.items()):
        colour, marker = _look(row)
        gone = lost(group, period) if period else []
        expected = {tick.expected for tick in group if not period} | set(gone)
        if period and group:
            last = max(group[-1].real, group[0].expected)
            steps = int((last - group[0].expected) / period + 1e-3) + 1
            expected |= {group[0].expected + step * period for step in range(steps)}
        axes.vlines(sorted(expected), row - 0.38, row + 0.38, _TEXT, lw=0.8, alpha=0.55)
        axes.plot(gone, [row + 0.27] * len(gone), "x", color=_TEXT, ms=5, lw=0)
        # One collection: an artist for each bar takes ten times as long.
        bars = [(tick.real, tick.duration) for tick in group if tick.duration > 0]
        axes.broken_barh(bars, (row - 0.15, 0.3), color=colour, alpha=0.45, lw=0)
        # Ticks at the same time are drawn one above the other.
        heights = [row - 0.24 * (tick.real - before.real < 1e-3) for before, tick in pairwise(group)]
        axes.plot([tick.real for tick in group], [row, *heights][: len(group)], marker, color=colour, ms=4.5, lw=0)
        words.append(describe_timeline(name, group) + (f" Lost ticks: {len(gone)}." if period else ""))
    axes.set_yticks(range(len(groups)), list(groups))
    axes.set_ylim(len(groups) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("time (s); line: expected, mark: real" + (", cross: lost" if period else ""))
    axes.use_sticky_edges = False  # a bar that begins at 0 would cut the mark there in half
    axes.margins(x=0.03)
    axes.axvline(0, lw=0)  # the run began at 0
    return _figure(canvas, "Timeline. " + " ".join(words))


@_styled
def lateness(ticks: Ticks) -> Figure:
    """Plot how late each tick was (ms) against the time at which it was expected (s)."""
    groups = _groups(ticks)
    canvas, axes = _canvas(2.3)
    words = []
    for row, (name, group) in enumerate(groups.items()):
        colour, marker = _look(row)
        axes.plot(
            [tick.expected for tick in group],
            [tick.lateness * 1e3 for tick in group],
            marker,
            color=colour,
            ms=3 if len(group) <= 200 else 1.5,
            label=name,
        )
        words.append(f"{name}: {describe_lateness(group)}")
    axes.axhline(0, color=_TEXT, lw=0.6, alpha=0.55)
    axes.set_xlabel("time expected (s)")
    axes.set_ylabel("lateness (ms)")
    if len(groups) > 1:
        canvas.legend(loc="outside upper left", ncols=len(groups))  # where no mark can be
    return _figure(canvas, "Lateness of each tick. " + " ".join(words))


@_styled
def period_histogram(ticks: Ticks) -> Figure:
    """Plot how often each period (ms) between two ticks occurred."""
    groups = _groups(ticks)
    canvas, axes = _canvas(2.3)
    times = [[period * 1e3 for period in periods(group)] for group in groups.values()]
    axes.hist(times, bins=40, color=[_look(row)[0] for row in range(len(groups))], label=list(groups))
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_xlabel("period (ms)")
    axes.set_ylabel("number of periods")
    if len(groups) > 1:
        canvas.legend(loc="outside upper left", ncols=len(groups))
    words = [f"{name}: {describe_periods(group)}" for name, group in groups.items()]
    return _figure(canvas, "Distribution of periods. " + " ".join(words))


def _groups(ticks: Ticks) -> dict[str, list[Tick]]:
    named = ticks if isinstance(ticks, Mapping) else by_source(ticks)
    groups = {name: list(group) for name, group in named.items()}
    if not any(groups.values()):
        raise ValueError("there are no ticks to plot")
    return groups


def _look(row: int) -> tuple[str, str]:
    return _COLOURS[row % len(_COLOURS)], _MARKERS[row % len(_MARKERS)]


def _canvas(height: float) -> tuple[Canvas, Axes]:
    canvas = Canvas(figsize=(_WIDTH, height), layout="constrained")
    axes = canvas.subplots()
    canvas.patch.set_visible(False)
    axes.patch.set_visible(False)
    return canvas, axes


def _figure(canvas: Canvas, alt: str) -> Figure:
    out = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": alt}):
        canvas.savefig(out, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    svg = out.getvalue()
    svg = svg[svg.index("<svg") :].strip().replace(_TEXT, "currentColor")
    svg = re.sub(r"font: ([\d.]+px)[^;\"]*", r"font-size: \1", svg)
    svg = re.sub(r"font-family: [^;\"]*", "font-family: inherit", svg)
    # Inside of a page this would style all of it.
    svg = re.sub(r"<defs>\s*<style.*?</style>\s*</defs>", "", svg, count=1, flags=re.DOTALL)
    # Several plots share a page: their ids must differ.
    key = hashlib.sha256(svg.encode()).hexdigest()[:8]
    svg = re.sub(r'\bid="', f'id="{key}-', svg)
    svg = re.sub(r'(url\(|href=")#', rf"\1#{key}-", svg)
    box = re.search(r'viewBox="([^"]*)"', svg)
    assert box is not None
    opening = (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        f'viewBox="{box[1]}" role="img" aria-label="{html.escape(alt)}" '
        'style="width: 100%; max-width: 34rem; stroke-linejoin: round; font-family: inherit">'
    )
    return Figure(opening + svg[svg.index(">") + 1 :], alt)
