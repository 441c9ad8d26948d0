"""Time, and the kinds of clocks that tell it (source: rclpy/time.py, rclpy/clock_type.py)."""

from __future__ import annotations

from enum import IntEnum
from importlib import import_module
from typing import Any, overload

from ..clocks.clock import BEGINS_AT_0, NS
from .duration import Duration, Held, Ordered

__all__ = ["ClockType", "Time"]


class ClockType(IntEnum):
    """The time that a clock tells: the system's, one that never jumps, or ROS's (the system's, or /clock's)."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class Time(Held, Ordered):
    """A time on one kind of clock: seconds (with their fraction) plus nanoseconds since its epoch.

    Raises ValueError for a negative time and OverflowError for one that is too large. Times of different kinds of
    clocks cannot be compared (TypeError).
    """

    _rosspin_held = "rcl_time_point_t"

    def __init__(
        self, *, seconds: float = 0, nanoseconds: int = 0, clock_type: ClockType = ClockType.SYSTEM_TIME
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if seconds < 0:
            raise ValueError("Seconds value must not be negative")
        if nanoseconds < 0:
            raise ValueError("Nanoseconds value must not be negative")
        self._rosspin_ns = int(seconds * NS) + int(nanoseconds)
        self._rosspin_type = clock_type
        if self._rosspin_ns >= 2**63:
            raise OverflowError("Total nanoseconds value is too large to store in C time point.")

    @property
    def clock_type(self) -> ClockType:
        """The kind of clock that tells it."""
        return self._rosspin_type

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Whole seconds, and the nanoseconds beyond them."""
        return divmod(self.nanoseconds, NS)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self.nanoseconds}, clock_type={self.clock_type.name})"

    def _rosspin_other(self, other: object) -> int | None:
        if not isinstance(other, Time):
            return None
        if self.clock_type != other.clock_type:
            raise TypeError("Can't compare times with different clock types")
        return other.nanoseconds

    def __add__(self, other: Duration) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        try:
            return Time(nanoseconds=self.nanoseconds + other.nanoseconds, clock_type=self.clock_type)
        except OverflowError as error:
            raise OverflowError("Addition leads to overflow in C storage.") from error

    __radd__ = __add__

    @overload
    def __sub__(self, other: Time) -> Duration: ...
    @overload
    def __sub__(self, other: Duration) -> Time: ...
    def __sub__(self, other: Time | Duration) -> Time | Duration:
        if isinstance(other, Time):
            if self.clock_type != other.clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self.nanoseconds - other.nanoseconds)
        if not isinstance(other, Duration):
            return NotImplemented
        try:
            return Time(nanoseconds=self.nanoseconds - other.nanoseconds, clock_type=self.clock_type)
        except ValueError as error:
            negative = ValueError("Subtraction leads to negative time.")
            negative.add_note(BEGINS_AT_0)
            raise negative from error

    def to_msg(self) -> Any:
        """Return the time as a message, builtin_interfaces/Time."""
        seconds, nanoseconds = self.seconds_nanoseconds()
        return import_module("builtin_interfaces.msg").Time(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Make a Time on a kind of clock from a message. Raises TypeError for any other message."""
        if not isinstance(msg, import_module("builtin_interfaces.msg").Time):
            raise TypeError("Must pass a builtin_interfaces.msg.Time object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
