"""Where a timeline has what: its rows, the lanes and heights of its marks, and the numbers of its axis.

Both drawings go by this: matplotlib's, and a page's while a run lasts or a handle moves, whose script has the
same constants, by :mod:`rosspin.site.rules`, and rules that a test compares with these.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

__all__ = [
    *("ABOVE", "AXIS", "BAR", "COLOURS", "COLUMNS", "KINDS", "MANY", "MARGIN", "MOST_ABOVE", "REACH", "ROW", "STEPS"),
    *("TICKS", "TITLE", "TOP", "constants", "heights", "lanes", "numbers", "to_draw"),
]

KINDS = 3  # of rows, each with a colour and a mark of its own
# Blue, vermilion and green of Okabe and Ito's colour-blind-safe set: at least 3:1 on white and on near-black alike.
COLOURS = ("#0072b2", "#d55e00", "#009e73")

MANY = 600  # the most marks in a row: more would run into each other
COLUMNS = 120  # of a row in which not all marks are drawn

# In a picture of its own, in px.
TOP = 2  # above the first row
ROW = 54  # its name, and below that its ticks
TICKS = 34  # how far the middle of the ticks is below the top of their row
REACH = 13  # how far a line for an expected tick goes up and down from there
BAR = 10  # how high the bar of a call is, at most
ABOVE, MOST_ABOVE = 10, 2  # how far a tick is above one that came at the same time, and for how many ticks
AXIS = 42  # with its numbers and its title, and what is above the first row
MARGIN = 0.016  # of the width, on either side of the ticks: half a mark
STEPS = 7  # at most, between the numbers of an axis
TITLE = "time (s); line: expected, mark: real"

# Ticks that are closer (s) are at the same time, and calls that overlap by less are not side by side.
_CLOSE = 1e-3


def constants() -> dict[str, Any]:
    """Return what the script of a page has, too."""
    return {
        **{"kinds": KINDS, "colours": COLOURS, "many": MANY, "columns": COLUMNS, "top": TOP, "row": ROW},
        **{"reach": REACH, "bar": BAR, "above": ABOVE, "mostAbove": MOST_ABOVE, "axis": AXIS, "margin": MARGIN},
        **{"ticks": TICKS, "steps": STEPS, "title": TITLE, "close": _CLOSE},
    }


def lanes(ticks: Sequence[tuple[float, float]]) -> tuple[list[float], float]:
    """Return how far (px) each call of a row is below its middle, and how high its bar is.

    Of each tick, it is given when (s) it came and how long (s) it took. Calls that overlap get a lane each.
    """
    ends: list[float] = []  # of the last call in each lane
    taken = []
    for real, duration in ticks:
        lane = next((lane for lane, end in enumerate(ends) if end < real + _CLOSE), len(ends))
        ends[lane : lane + 1] = [real + duration]
        taken.append(lane)
    pitch = 2 * REACH / max(len(ends), 1)
    return [(lane - (len(ends) - 1) / 2) * pitch for lane in taken], max(min(BAR, pitch - 1), 0.5)


def heights(ticks: Sequence[tuple[float, float]]) -> list[float]:
    """Return how far (px) the marks of a row are below its middle. Up to three at one time are above each other."""
    down, _ = lanes(ticks)
    found, above = [], 0
    for n, (real, _) in enumerate(ticks):
        is_above = n > 0 and real - ticks[n - 1][0] < _CLOSE and down[n] == down[n - 1]
        above = min(above + 1, MOST_ABOVE) if is_above else 0
        found.append(down[n] - above * ABOVE)
    return found


def to_draw(across: Sequence[float], up: Sequence[float], most: int = MANY) -> list[int]:
    """Return which points to draw: all, or, if they are more than ``most``, the lowest and highest in each column."""
    if len(across) <= most:
        return list(range(len(across)))
    first = min(across)
    width = (max(across) - first) / max(min(COLUMNS, most / 2 - 1), 1) or 1.0
    columns: dict[int, tuple[int, int]] = {}
    for n, (x, y) in enumerate(zip(across, up, strict=True)):
        low, high = columns.setdefault(int((x - first) / width), (n, n))
        columns[int((x - first) / width)] = (n if y < up[low] else low, n if y > up[high] else high)
    return sorted({n for pair in columns.values() for n in pair})


def numbers(first: float, span: float) -> list[float]:
    """Return the numbers of an axis that is ``span`` long, above 0: their step is 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(span / STEPS))
    size = power * next((factor for factor in (1, 2, 5) if span / (factor * power) <= STEPS), 10)
    begin = math.ceil(first / size - 1e-9)
    # They are counted: added to a number that is large enough, 1 changes nothing.
    found = [(begin + count) * size for count in range(STEPS + 1)]
    return [number for number in found if number <= first + span + 1e-9 * size]
