"""A drive as the page draws it: paths of SVG, which ``web/src/drive.js`` puts in their places."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import groupby

from .drives import Drive, Spot
from .physics import EDGE, line

__all__ = ["drawn"]

_MOST = 2000  # points of a way, and marks


def drawn(drive: Drive, ticks: Iterable[float], seconds: float) -> list[str]:
    """Draw a drive of a run of ``seconds``, with the times of the steering node's ticks; nothing if there was none.

    In their order: what is seen, in words; of the way, the box that it needs, the line, the way, the parts of it that
    are off the line, where commands came, and how the vehicle is placed in the end; of the deviation, over 1000 by 100,
    the curve and the edge, and below it the marks of ticks and of commands; and how long and how high that is.
    """
    if not drive.spots:
        return []
    spots = _some(drive.spots)
    across, up = [spot.x for spot in spots], [-spot.y for spot in spots]
    left, right = min(-0.5, *across), max(11.0, max(across) + 0.6)
    top, bottom = min(-1.6, min(up) - 0.4), max(1.6, max(up) + 0.4)
    most = max(2 * EDGE, math.ceil(11 * drive.worst.off) / 10)
    last = spots[-1]
    off = [list(part) for is_off, part in groupby(spots, lambda spot: spot.off > EDGE) if is_off]
    sent = _some([command.time for command in drive.commands])
    curve = "L".join(f"{_across(spot.time, seconds)} {100 - 100 * spot.off / most:.2f}" for spot in spots)
    edge = 100 - 100 * EDGE / most
    return [
        drive.words,
        f"{left:.2f} {top:.2f} {right - left:.2f} {bottom - top:.2f}",
        "M" + "L".join(f"{x:.2f} {-y:.2f}" for x, y in line(right - 0.3)[::15]),  # its round end is seen
        _path(spots),
        "".join(map(_path, off)),
        "".join(f"M{spot.x:.2f} {-spot.y:.2f}h0" for spot in _at(spots, sent)),
        f"translate({last.x:.2f} {-last.y:.2f}) rotate({-math.degrees(last.heading):.1f})",
        f"M{curve}",
        f"M0 {edge:.2f}H1000",
        *("".join(f"M{_across(time, seconds)} 0v1" for time in times) for times in (_some(list(ticks)), sent)),
        f"{seconds:g}",
        f"{most:g}",
    ]


def _some(items: Sequence[object]) -> Sequence:  # type: ignore[type-arg]
    return items[:: max(math.ceil(len(items) / _MOST), 1)]


def _across(time: float, seconds: float) -> str:
    return f"{1000 * time / (seconds or 1):.1f}"


def _path(spots: Sequence[Spot]) -> str:
    return "M" + "L".join(f"{spot.x:.2f} {-spot.y:.2f}" for spot in spots)


def _at(spots: Sequence[Spot], times: Sequence[float]) -> Iterable[Spot]:
    """Yield where the vehicle was at these times, which are in their order."""
    number = 0
    for time in times:
        while number + 1 < len(spots) and spots[number].time < time:
            number += 1
        yield spots[number]
