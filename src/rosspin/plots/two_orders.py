"""Plot two orders of one run, the usual one and another, where they differ."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, NamedTuple

from ..results.orders import Instant, Orders, Step
from . import pictures
from .layout import AXIS, BAR, KINDS, ROW, TICKS
from .rows import COLOURS, MARKS, Row, describe, draw_rows, height_of, make_row

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["both_orders", "orders"]

_PANELS = ("the usual order", "this order")
_STEPS = 16  # the most steps that are drawn of each order
_LINE = 16  # of text, in points
_CHARACTERS = 50  # of such a line on a phone


def orders(both: Orders, *, caption: str | None = None, ax: Axes | None = None) -> Axes:
    """Plot an order that :func:`rosspin.explore` has found below the usual one, step by step, where they differ.

    Each order has a row for each thread. A mark is a line of the node, with its number; a bar continues for as long as
    its thread does. What comes first is on the left, also within an instant; each instant has a ground of its own, with
    its time below. A dashed line shows where the orders part, and what was chosen there. Up to 16 steps are drawn.

    Raises ValueError if no lines are known, as of functions, or if all of them are the same.
    """
    shown, left = _windows(both.instants)
    if not shown:
        raise ValueError("the two orders have no lines that differ")
    threads = list(dict.fromkeys(step.thread for window in shown for column in window.steps for step in column if step))
    gap = sum(len(window.parting) for window in shown) * _LINE / ROW + 0.2
    caption = "simulated" if caption is None else caption
    alt = " ".join(_describe_orders(window) for window in shown)
    with pictures.drawing(ax, f"Two orders of one run, step by step. {alt}", caption, _orders_height(both)) as ax:
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
            # Next to its line if there is room for it on a phone.
            at, width = window.at, end * max(map(len, window.parting)) / _CHARACTERS
            x, side = (at - 0.4, "left") if at + width < end else (at - 0.6, "right") if at > width else (-0.5, "left")
            ax.text(x, down, "\n".join(window.parting), ha=side, va="top", fontsize=12.5)
            down += len(window.parting) * _LINE / ROW
        names = [f"{_PANELS[panel]}: {thread}" for panel, thread in places]
        ax.set_yticks(list(places.values()), names, ha="left", va="top", weight="bold")
        ax.tick_params(axis="y", length=0, pad=0)
        ax.grid(visible=False)
        ax.set_xticks([(each.first + each.end - 1) / 2 for each in shown], [f"{each.time:.9g}" for each in shown])
        ax.set_xlabel(f"time (s); mark: a line of the node, with its number{left}", loc="right")
        ax.set_xlim(-0.8, shown[-1].end - 0.2)
        ax.set_ylim(bottom, 0)
    return ax


def both_orders(both: Orders, *, caption: str | None = None) -> Figure:
    """Draw two orders on one timeline, with the times at which they part, and :func:`orders` below that.

    One of both is left out if there is nothing to show in it. The figure is unknown to pyplot. Raises ValueError if
    there is nothing at all.
    """
    caption = "simulated" if caption is None else caption
    runs = {name: run for name, run in zip(_PANELS, (both.usual, both.here), strict=True) if run}
    ticks = {name: run.ticks for name, run in runs.items()}
    heights, is_timed = [], any(ticks.values())
    rows = [make_row(name, group, None, ()) for name, group in ticks.items()]
    marks = [(round(each.time, 6), 0.0) for each in both.instants if each.deviations]
    parts = [Row("where this order deviates", "", [], [], marks)]
    if is_timed:
        heights.append(height_of([*rows, *parts]))
    if _windows(both.instants)[0]:
        heights.append(_orders_height(both))
    if not heights:
        raise ValueError("there are no ticks to plot, and no lines that differ")
    axes = pictures.new_column(heights)
    if is_timed:
        at = ", ".join(f"{time:g} s" for time, _ in marks)
        alt = f"{describe(ticks, None, {})} This order deviates at {at}."
        ends = [run.seconds for run in runs.values()]
        draw_rows(rows, None, len(rows), alt, caption, axes[0], ends, parts)
    if len(heights) > is_timed:
        orders(both, caption=caption, ax=axes[-1])
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


def _orders_height(both: Orders) -> int:
    shown, left = _windows(both.instants)
    threads = {step.thread for window in shown for column in window.steps for step in column if step}
    lines = sum(len(window.parting) for window in shown)
    return round((2 * len(threads) + 0.2) * ROW) + (lines + bool(left)) * _LINE + AXIS


def _describe_orders(window: _Window) -> str:
    orders = []
    for name, column in zip(_PANELS, window.steps, strict=True):
        groups = groupby(filter(None, column), lambda step: step.thread)
        steps = ", then ".join(f"{thread}: {', '.join(step.line for step in group)}" for thread, group in groups)
        orders.append(f"lines in {name}: {steps or 'none'}")
    return f"At {window.time:.9g} s, {'; '.join(orders)}. They part: {' '.join(window.parting)}."


def _draw_steps(
    ax: Axes, window: _Window, column: Sequence[Step | None], rows: Mapping[str, float], threads: Sequence[str]
) -> None:
    """Draw the steps of one order in one instant, and a bar for as long as the same thread continues."""
    known = [(n, step) for n, step in enumerate(column, window.first) if step]
    for thread, group in groupby(known, lambda each: each[1].thread):
        steps, down, kind = list(group), rows[thread] + TICKS / ROW, threads.index(thread) % KINDS
        left, right = steps[0][0] - 0.4, steps[-1][0] + 0.4
        ax.barh([down], [right - left], BAR / ROW, left, color=COLOURS[kind], alpha=0.45)
        ax.plot([n for n, _ in steps], [down] * len(steps), ls="", c=COLOURS[kind], **MARKS[kind])
        for n, step in steps:
            weight = "bold" if n >= window.at else "normal"
            number = step.line.rpartition(":")[2]
            ax.annotate(number, (n, down), (0, -6), textcoords="offset points", ha="center", va="top", weight=weight)
