"""rospy.Time, rospy.Duration and the current time (source: rospy/rostime.py)."""

from __future__ import annotations

import threading

from ..clocks.clock import nanoseconds
from ..messages import genpy
from .state import state

__all__ = ["Duration", "Time", "get_rostime", "get_time", "is_wallclock", "switch_to_wallclock", "wallsleep"]


class Duration(genpy.Duration):
    """A length of time of ``secs`` seconds and ``nsecs`` nanoseconds; it may be negative.

    ``secs`` may be a float if ``nsecs`` is 0 (else ValueError); fractions of a nanosecond are cut off.
    """

    __slots__: list[str] = []

    def __repr__(self) -> str:
        return f"rospy.Duration[{self.to_nsec()}]"


class Time(genpy.Time):
    """A point in time, ``secs`` seconds and ``nsecs`` nanoseconds after the epoch or, when simulated, after the start.

    ``secs`` may be a float if ``nsecs`` is 0 (else ValueError). Raises TypeError if it would be negative.
    """

    __slots__: list[str] = []

    def __repr__(self) -> str:
        return f"rospy.Time[{self.to_nsec()}]"

    @staticmethod
    def now() -> Time:
        """Return the current time. Raises ROSInitException before ``init_node``."""
        return get_rostime()

    @classmethod
    def from_seconds(cls, float_secs: float) -> Time:
        """The old name of ``from_sec``."""
        return cls.from_sec(float_secs)


def get_rostime() -> Time:
    """Return the current time. Raises ROSInitException before ``init_node``."""
    return Time._of(state().now())


def get_time() -> float:
    """Return the current time in seconds. Raises ROSInitException before ``init_node``."""
    return get_rostime().to_sec()


def is_wallclock() -> bool:
    """Whether the node runs on its own clock, and not on ROS time as told by /clock."""
    return state().ros_time is None


def is_rostime_initialized() -> bool:
    """Whether the time can be asked for."""
    return state().time_initialized


def set_rostime_initialized(val: bool) -> None:
    """Set whether the time can be asked for."""
    state().time_initialized = val


def _set_rostime(t: genpy.Time) -> None:
    """Set ROS time, as each message on /clock does. Sleeping calls wake up and look at it."""
    if not isinstance(t, genpy.Time):
        raise ValueError(f"must be Time instance: {t.__class__}")
    state().set_ros_time(t.to_nsec())


def get_rostime_cond() -> threading.Condition:
    """Return the condition that is notified whenever ROS time is set."""
    return state().ros_time_changed


def switch_to_wallclock() -> None:
    """Go back from ROS time to the node's own clock."""
    state().set_ros_time(None)


def wallsleep(duration: float) -> None:
    """Sleep on the node's own clock, for ``duration`` seconds (negative: ValueError)."""
    if duration < 0:
        raise ValueError("sleep length must be non-negative")
    state().clock.sleep(nanoseconds(duration))
