"""How the vehicle moves along its line. Lengths are in metres, angles in radians, times in seconds; y points up."""

from __future__ import annotations

import math
from itertools import count, takewhile
from typing import NamedTuple

__all__ = ["AHEAD", "EDGE", "FASTEST", "START", "STEP", "Place", "Vehicle", "line", "nearest", "point"]

EDGE = 0.25  # farther than this from its line, it has left it
FASTEST = 2.0  # m/s; told to drive faster, it drives so fast
AHEAD = 0.6  # how far before its middle the sensor is
STEP = 0.01  # between points of the line
_TIGHTEST = 8.0  # rad/s, likewise

_points: list[tuple[float, float]] = [(0.0, 0.0)]


def point(number: int) -> tuple[float, float]:
    """Return a point of the line, which winds like a sine and never ends. They are numbered from the start, 0."""
    while number >= len(_points):
        x = _points[-1][0]
        x += STEP / math.hypot(1, 1.2 * math.tau / 7 * math.cos(x * math.tau / 7))
        _points.append((x, 1.2 * math.sin(x * math.tau / 7)))
    return _points[max(number, 0)]


def line(far: float) -> list[tuple[float, float]]:
    """Return the points of the line whose x is less than ``far``."""
    return list(takewhile(lambda each: each[0] < far, map(point, count())))


def nearest(x: float, y: float, number: int) -> int:
    """Find the nearest point of the line, from where it was last: the line may come near twice."""
    for step in (1, -1):
        while number + step >= 0 and math.dist((x, y), point(number + step)) < math.dist((x, y), point(number)):
            number += step
    return number


class Place(NamedTuple):
    """Where something is, and where it is heading: 0 along x, from there to the left."""

    x: float
    y: float
    heading: float

    def after(self, way: float, turned: float) -> Place:
        """Return the place at the end of an arc of this length, on which the heading has turned by so much."""
        half = turned / 2
        # The chord of the arc points where the vehicle headed halfway.
        chord, middle = way * (math.sin(half) / half if half else 1.0), self.heading + half
        return Place(self.x + chord * math.cos(middle), self.y + chord * math.sin(middle), self.heading + turned)


START = Place(0.0, 0.0, math.atan2(point(1)[1], point(1)[0]))


class Vehicle:
    """Drives and turns as it was told last; its time is what it is told.

    Attributes: ``place``, and ``speed`` (m/s) and ``turn`` (rad/s, to the left), which the wheels keep.
    """

    def __init__(self) -> None:
        self.place = START
        self.speed = self.turn = 0.0
        self._time = 0.0
        self._below = self._before = 0  # the points of the line that are nearest to its middle, and to its sensor

    def tell(self, speed: float, turn: float) -> None:
        """Set the wheels. It cannot go faster than :data:`FASTEST`; what is no number stops it."""
        self.speed, self.turn = _within(speed, FASTEST), _within(turn, _TIGHTEST)

    def move(self, time: float) -> None:
        """Drive on until this time."""
        passed, self._time = time - self._time, time
        self.place = self.place.after(self.speed * passed, self.turn * passed)

    @property
    def deviation(self) -> float:
        """How far its middle is from the line."""
        self._below = nearest(self.place.x, self.place.y, self._below)
        return math.dist(self.place[:2], point(self._below))

    @property
    def offset(self) -> float:
        """How far to the left of its sensor the line is: what the sensor sees."""
        x, y, heading = self.place.after(AHEAD, 0.0)
        self._before = nearest(x, y, self._before)
        line_x, line_y = point(self._before)
        return math.cos(heading) * (line_y - y) - math.sin(heading) * (line_x - x)


def _within(value: float, most: float) -> float:
    return max(-most, min(most, value)) if math.isfinite(value) else 0.0
