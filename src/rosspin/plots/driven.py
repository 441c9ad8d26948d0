"""A drive in pictures: the way of the vehicle, and how far off its line it was."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from ..vehicle.drives import Drive
from ..vehicle.physics import EDGE, Place
from . import pictures
from .layout import COLOURS, MARGIN, numbers
from .vehicle import draw

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["ROAD", "draw_off", "draw_way"]

ROAD = 250  # px, the height of the way


def draw_way(drive: Drive, caption: str, ax: Axes) -> None:
    """Draw the vehicle where it is in the end, and its way there, with a dot where it was told something."""
    with pictures.drawing(ax, drive.words, caption) as ax:
        way = [(spot.x, spot.y) for spot in drive.spots]
        last = drive.spots[-1]
        across, up = zip(*way, strict=True)
        left, right = min(-0.5, *across), max(11.0, max(across) + 0.6)
        # The road ends where its round end is still seen.
        draw(ax, way, _off(drive), list(_turns(drive)), Place(last.x, last.y, last.heading), 0.7, right - 0.3)
        ax.set(xlim=(left, right), ylim=(min(-1.6, min(up) - 0.4), max(1.6, max(up) + 0.4)), aspect="equal")
        ax.set_axis_off()


def draw_off(drive: Drive, caption: str, ax: Axes) -> None:
    """Draw how far off its line the vehicle was, and from where on that is too far."""
    alternative = f"Deviation from the line: at most {drive.worst.off:.2f} m, at {drive.worst.time:g} s."
    with pictures.drawing(ax, alternative, caption) as ax:
        ax.plot([spot.time for spot in drive.spots], [spot.off for spot in drive.spots])
        ax.axhline(EDGE, color=COLOURS[1], lw=1.5, ls="--")
        ax.set_ylim(0, max(2 * EDGE, 1.1 * drive.worst.off))
        ax.set_ylabel("deviation (m)")
        ax.update_datalim([(0.0, 0.0)])
        ax.use_sticky_edges = False
        ax.margins(x=pictures.margin(MARGIN))
        pictures.number(ax, numbers)
        ax.set_xlabel(f"time (s), dashed: {EDGE:g} m", loc="right")


def _off(drive: Drive) -> Iterator[Sequence[tuple[float, float]]]:
    """Yield the parts of the way that are off the line."""
    for is_off, spots in groupby(drive.spots, lambda spot: spot.off > EDGE):
        if is_off:
            yield [(spot.x, spot.y) for spot in spots]


def _turns(drive: Drive) -> Iterator[tuple[float, float]]:
    """Yield where the vehicle was when a command came."""
    spots = iter(drive.spots)
    spot = next(spots)
    for command in drive.commands:
        while spot.time < command.time and (later := next(spots, None)):
            spot = later
        yield spot.x, spot.y
