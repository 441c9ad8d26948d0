"""A vehicle on a winding line, steered at the ticks of a run: what a late tick does.

At each tick it looks for the point of the line that is a metre ahead, and turns its wheels so that it would reach that
point ("pure pursuit"). Until the next tick the wheels stay as they are, so it drives along an arc. Lengths are in
metres, y points up; times are in seconds.
"""

from __future__ import annotations

import cmath
import html
import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from ..vehicle.drives import say_off
from ..vehicle.physics import START, STEP, Place, line, nearest, point
from . import pictures

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["PERIOD", "SECONDS", "Drive", "draw", "drive", "preview", "svg"]

PERIOD = 0.5  # of the ticks, if none is late
SECONDS = 12.0  # of each run
_SPEED = 1.2  # m/s
_AHEAD = 1.0  # how far it looks along the line

_BOX = "-0.5 -1.75 12.4 4.2"  # what a picture shows: left, top, width, height; y points down there
_PX = 760  # how wide a file is
_BLUE, _ORANGE = "#0072b2", "#d55e00"
_BODY = ((-0.34, -0.2), (0.2, -0.2), (0.42, -0.09), (0.42, 0.09), (0.2, 0.2), (-0.34, 0.2))  # heading to the right
_VEHICLE = (
    '<path d="M-.22 -.24h.16M.14 -.24h.16M-.22 .24h.16M.14 .24h.16" stroke="currentColor" stroke-width=".13"/>'
    f'<path d="M{"L".join(f"{x:g} {y:g}" for x, y in _BODY)}Z" fill="{_ORANGE}" stroke="currentColor"'
    ' stroke-width=".04" stroke-linejoin="round"/>'
)


class _Arc(NamedTuple):
    """From ``time`` on it drives from (x, y), heading in radians, along a curve of this curvature (1/m)."""

    time: float
    x: float
    y: float
    heading: float
    curvature: float

    def after(self, seconds: float) -> Place:
        """Return where the vehicle is then."""
        way = _SPEED * seconds
        return Place(self.x, self.y, self.heading).after(way, self.curvature * way)


class Drive(NamedTuple):
    """A drive: the ``arcs`` from the start and from each tick on, and where and when it was ``off`` its line most."""

    arcs: list[_Arc]
    off: float
    when: float

    @property
    def overdue(self) -> list[tuple[float, float]]:
        """From when to when it should have been steered, and was not."""
        times = [*(arc.time for arc in self.arcs), SECONDS]
        return [(a + PERIOD, b) for a, b in pairwise(times) if b > a + PERIOD + 1e-3]

    @property
    def dashes(self) -> str:
        """The overdue stretches, as an SVG dash array; the path is as long as the run."""
        times = [time for both in self.overdue for time in both]
        return " ".join(f"{b - a:.4g}" for a, b in pairwise([0, 0, *times, 2 * SECONDS]))

    @property
    def words(self) -> str:
        """What is seen of it."""
        return say_off(self.off, self.when)

    @property
    def path(self) -> str:
        """The way as SVG, where y points down."""
        parts = [f"M{self.arcs[0].x:g} {-self.arcs[0].y:g}"]
        for arc, end in zip(self.arcs, [*(arc.time for arc in self.arcs[1:]), SECONDS], strict=True):
            x, y, _ = arc.after(end - arc.time)
            radius = min(1 / abs(arc.curvature), 1e3) if arc.curvature else 1e3
            is_large = abs(arc.curvature) * _SPEED * (end - arc.time) > math.pi
            parts.append(f"A{radius:.4g} {radius:.4g} 0 {is_large:d} {arc.curvature < 0:d} {x:.3f} {-y:.3f}")
        return "".join(parts)

    def at(self, time: float) -> Place:
        """Return where the vehicle is at a time."""
        arc = next(arc for arc in reversed(self.arcs) if arc.time <= time)
        return arc.after(time - arc.time)


def drive(ticks: Iterable[float]) -> Drive:
    """Drive along the line for :data:`SECONDS`, steering at these times (s, in order)."""
    place, arc = 0, _Arc(0.0, *START, 0.0)
    arcs, off, when = [], 0.0, 0.0
    for tick in [*(tick for tick in ticks if tick < SECONDS), SECONDS]:
        arcs.append(arc)
        steps = math.ceil((tick - arc.time) / 0.02)
        for seconds in (step * (tick - arc.time) / steps for step in range(1, steps + 1)):
            x, y, heading = arc.after(seconds)
            place = nearest(x, y, place)
            if (distance := math.dist((x, y), point(place))) > off:
                off, when = distance, arc.time + seconds
        ahead, up = point(place + round(_AHEAD / STEP))
        across = math.cos(heading) * (up - y) - math.sin(heading) * (ahead - x)
        arc = _Arc(tick, x, y, heading, 2 * across / math.dist((x, y), (ahead, up)) ** 2)
    return Drive(arcs, off, when)


def svg(drive: Drive, alternative: str, standalone: bool = False) -> str:
    """Draw the line, the way with a dot for each tick, where a tick is overdue, and the vehicle where it is off most.

    ``web/src/vehicle.js`` moves the parts that have a class. ``standalone``: as a file, light or dark as its viewer is.
    """
    x, y, heading = drive.at(drive.when)
    file = f' xmlns="http://www.w3.org/2000/svg" width="{_PX}"' if standalone else ' width="100%"'
    road = "M" + "L".join(f"{x:.2f} {-y:.2f}" for x, y in line(12.0)[::15])
    return f"""\
<svg{file} class="rosspin-road" role="img" aria-label="{html.escape(alternative)}" viewBox="{_BOX}" fill="none"
  stroke-linecap="round">{f"<style>{pictures.STANDALONE}</style>" if standalone else ""}
<marker id="rosspin-tick" viewBox="-1 -1 2 2" markerWidth="2.2"><circle r="1" fill="{_BLUE}"/></marker>
<path d="{road}" stroke="currentColor" stroke-opacity="0.12" stroke-width="0.5"/>
<path d="{road}" stroke="currentColor" stroke-opacity="0.5" stroke-width="0.03" stroke-dasharray="0.12"/>
<path class="way" d="{drive.path}" stroke="{_BLUE}" stroke-width="0.07" marker-mid="url(#rosspin-tick)"/>
<path class="way overdue" d="{drive.path}" stroke="{_ORANGE}" stroke-width="0.13" stroke-linecap="butt"
  pathLength="{SECONDS:g}" stroke-dasharray="{drive.dashes}"/>
<g class="vehicle" transform="translate({x:.3f} {-y:.3f}) rotate({-math.degrees(heading):.1f})">{_VEHICLE}</g>
</svg>"""


def preview(drive: Drive, title: str, words: str) -> Figure:
    """Draw the same as the picture of a link, with words above and below it: 1200 by 630 px at 100 dpi."""
    ax = pictures.new_axes(630)
    figure = pictures.figure_of(ax)
    figure.set_size_inches(12, 6.3)
    figure.set_layout_engine("none")
    left, top, width, height = map(float, _BOX.split())
    ax.set(position=(0, 0.14, 1, 0.66), xlim=(left, left + width), ylim=(-top - height, -top), aspect="equal")
    ax.set_axis_off()
    times = [n * 0.02 for n in range(round(SECONDS / 0.02) + 1)]
    way = [drive.at(time)[:2] for time in times]
    late = [[place for time, place in zip(times, way, strict=True) if a <= time <= b] for a, b in drive.overdue]
    draw(ax, way, late, [arc[1:3] for arc in drive.arcs[1:]], drive.at(drive.when), 2.0)
    figure.text(0.05, 0.86, title, size=36, weight="bold")
    figure.text(0.05, 0.07, words, size=20)
    return figure


def draw(
    ax: Axes,
    way: Sequence[tuple[float, float]],
    marked: Iterable[Sequence[tuple[float, float]]],
    dots: Sequence[tuple[float, float]],
    place: Place,
    size: float,
    far: float = 20.0,
) -> None:
    """Draw the line, as ``far`` along x, a way along it, parts of that which are marked, dots on it, and the vehicle.

    A ``size`` of 1 is for a picture in a page.
    """
    road = list(zip(*line(far), strict=True))
    ax.plot(*road, c="black", alpha=0.12, lw=18 * size, solid_capstyle="round")
    ax.plot(*road, c="black", alpha=0.5, lw=0.75 * size, ls=(0, (5, 5)))
    ax.plot(*zip(*way, strict=True), c=_BLUE, lw=2.5 * size)
    for part in marked:
        ax.plot(*zip(*part, strict=True), c=_ORANGE, lw=4.5 * size, solid_capstyle="round")
    ax.plot([x for x, _ in dots], [y for _, y in dots], "o", c=_BLUE, ms=5.5 * size, mew=0)
    turned = [complex(*place[:2]) + complex(*point) * cmath.rect(1, place.heading) for point in _BODY]
    body = [point.real for point in turned], [point.imag for point in turned]
    ax.fill(*body, fc=_ORANGE, ec="black", lw=size, zorder=3)
