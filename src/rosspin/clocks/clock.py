"""What a clock is, and the one on the wall.

Times are integer nanoseconds, as in ROS: since the epoch on the wall, since the start of the run when simulated.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Protocol

__all__ = ["BEGINS_AT_0", "LATE", "NS", "Clock", "WallClock", "nanoseconds"]

NS = 1_000_000_000

# How much later (ns) than usual a connection may be made, where orders are explored. Nothing says when it is, and a
# computer that is busy easily takes a second.
LATE = NS

# A hint at times before 0, which a real computer's clock does not know.
BEGINS_AT_0 = "rosspin: simulated clocks begin at 0, unless you say --start 1.7e9, or simulate(..., start=1.7e9)"


def nanoseconds(seconds: float) -> int:
    """Convert a length of time from seconds to integer nanoseconds.

    Raises, in the words of ``time.sleep``, ValueError for NaN, OverflowError for a time that no clock can hold, and
    TypeError for anything that is not a number.
    """
    if isinstance(seconds, int):
        ns = seconds * NS
    else:
        if seconds != seconds:
            raise ValueError("Invalid value NaN (not a number)")
        if not isinstance(seconds, float):
            seconds = _number(seconds)
        ns = round(seconds * NS) if abs(seconds) < 2**63 else 2**63
    if not -(2**63) <= ns < 2**63:
        raise OverflowError("timestamp out of range for platform time_t")
    return ns


def _number(value: object) -> float:
    if hasattr(value, "__float__") or hasattr(value, "__index__"):
        return float(value)  # type: ignore[arg-type]
    raise TypeError(f"'{type(value).__name__}' object cannot be interpreted as an integer")


class Clock(Protocol):
    """What a stand-in needs of a clock. The rest is Python's own: threads, locks and conditions run on either clock.

    The system's clock tells ``ahead`` ns more than ``now()``, if it was set while it was simulated.
    """

    ahead: int

    def now(self) -> int:
        """The time, in ns."""

    def system(self) -> int:
        """What the system's clock tells, in ns."""

    def sleep(self, ns: int) -> None:
        """Suspend the caller for ``ns`` nanoseconds; others run meanwhile. 0 or less only lets others run."""

    @property
    def explores(self) -> bool:
        """Whether orders of events other than the usual one are tried."""

    def choose(self, options: Sequence[str]) -> int:
        """Return the place of what happens, of several things that ROS leaves open: the first unless it explores."""

    def give_way(self) -> None:
        """Let another thread of the caller's process continue if it explores: a real one could here, too."""


class WallClock:
    """Real time."""

    ahead = 0
    explores = False

    def now(self) -> int:
        """The time since the epoch, in ns."""
        return time.time_ns()

    system = now

    def sleep(self, ns: int) -> None:
        """Suspend the calling thread for ``ns`` nanoseconds."""
        if ns > 0:
            time.sleep(ns / NS)

    def choose(self, options: Sequence[str]) -> int:
        """Return 0."""
        return 0

    def give_way(self) -> None:
        """Do nothing."""
