"""genpy's Time and Duration, of which rospy's are subclasses (source: genpy/rostime.py).

Two values keep genpy's class, as they do on a real ROS: the difference of two times and what is computed from it.
"""

from __future__ import annotations

import sys
from numbers import Integral, Real
from typing import Any, ClassVar, TypeVar

from ..clocks.clock import BEGINS_AT_0

__all__ = ["Duration", "TVal", "Time"]

NS = 1_000_000_000
T = TypeVar("T", bound="TVal")
D = TypeVar("D", bound="Duration")
M = TypeVar("M", bound="Time")


class TVal:
    """What Time and Duration share: whole seconds and nanoseconds, ``0 <= nsecs < 1e9``.

    ``secs`` may be a float if ``nsecs`` is 0 (else ValueError); its fraction is cut off, not rounded, to nanoseconds.
    """

    __slots__ = ["secs", "nsecs"]
    _slot_types = ["int32", "int32"]  # as a message has them
    _comparable: ClassVar[type[TVal]]

    def __init__(self, secs: float = 0, nsecs: float = 0) -> None:
        if not isinstance(secs, Integral):
            if nsecs != 0:
                raise ValueError("if secs is a float, nsecs cannot be set")
            secs, nsecs = _split(secs)
        over, self.nsecs = divmod(int(nsecs), NS)
        self.secs = int(secs) + over

    @classmethod
    def from_sec(cls: type[T], float_secs: float) -> T:
        """Make a value from seconds, cut off to nanoseconds."""
        return cls(*_split(float_secs))

    @classmethod
    def _of(cls: type[T], ns: int) -> T:
        value = cls.__new__(cls)
        value.secs, value.nsecs = divmod(ns, NS)
        return value

    def is_zero(self) -> bool:
        """Whether both fields are 0."""
        return self.secs == 0 and self.nsecs == 0

    def set(self, secs: int, nsecs: int) -> None:
        """Set both fields, as they are."""
        self.secs = secs
        self.nsecs = nsecs

    def canon(self) -> None:
        """Bring fields that were set by hand into ``0 <= nsecs < 1e9``."""
        over, self.nsecs = divmod(self.nsecs, NS)
        self.secs += over

    def to_sec(self) -> float:
        """The value in seconds."""
        return float(self.secs) + float(self.nsecs) / 1e9

    def to_nsec(self) -> int:
        """The value in nanoseconds."""
        return self.secs * NS + self.nsecs

    def __hash__(self) -> int:
        return hash((self.secs, self.nsecs))

    def __str__(self) -> str:
        return str(self.to_nsec())

    def __repr__(self) -> str:
        return f"genpy.TVal[{self.to_nsec()}]"

    def __bool__(self) -> bool:
        return self.secs != 0 or self.nsecs != 0

    def __getstate__(self) -> list[int]:
        return [self.secs, self.nsecs]

    def __setstate__(self, state: list[int]) -> None:
        self.secs, self.nsecs = state

    # Times compare with times and durations with durations; a mixture is a TypeError, or unequal.
    def __eq__(self, other: object) -> bool:
        return isinstance(other, self._comparable) and self.__getstate__() == other.__getstate__()

    def __lt__(self, other: Any) -> bool:
        return self.to_nsec() < other.to_nsec() if isinstance(other, self._comparable) else NotImplemented

    def __le__(self, other: Any) -> bool:
        return self.to_nsec() <= other.to_nsec() if isinstance(other, self._comparable) else NotImplemented

    def __gt__(self, other: Any) -> bool:
        return self.to_nsec() > other.to_nsec() if isinstance(other, self._comparable) else NotImplemented

    def __ge__(self, other: Any) -> bool:
        return self.to_nsec() >= other.to_nsec() if isinstance(other, self._comparable) else NotImplemented


class Duration(TVal):
    """A length of time, which may be negative: Duration(-0.25) has secs -1, nsecs 750000000."""

    __slots__ = ["secs", "nsecs"]

    def __repr__(self) -> str:
        return f"genpy.Duration[{self.to_nsec()}]"

    def __neg__(self: D) -> D:
        return self._of(-self.to_nsec())

    def __abs__(self: D) -> D:
        return self if self.secs >= 0 else -self

    def __add__(self: D, other: Duration) -> D:
        return self._of(self.to_nsec() + other.to_nsec()) if isinstance(other, Duration) else NotImplemented

    __radd__ = __add__

    def __sub__(self: D, other: Duration) -> D:
        return self._of(self.to_nsec() - other.to_nsec()) if isinstance(other, Duration) else NotImplemented

    def __mul__(self: D, factor: float) -> D:
        if isinstance(factor, Integral):
            return self._of(self.to_nsec() * int(factor))
        if isinstance(factor, Real):
            return self.from_sec(self.to_sec() * factor)
        return NotImplemented

    __rmul__ = __mul__

    # Division goes by way of float seconds, as in genpy.
    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, Real):
            return self.from_sec(self.to_sec() / float(other))
        return self.to_sec() / other.to_sec() if isinstance(other, Duration) else NotImplemented

    def __floordiv__(self, other: Any) -> Any:
        if isinstance(other, Real):
            return self.from_sec(self.to_sec() // float(other))
        return int(self.to_sec() // other.to_sec()) if isinstance(other, Duration) else NotImplemented

    def __mod__(self: D, other: Duration) -> D:
        return self.from_sec(self.to_sec() % other.to_sec()) if isinstance(other, Duration) else NotImplemented

    def __divmod__(self: D, other: Duration) -> tuple[int, D]:
        if not isinstance(other, Duration):
            return NotImplemented
        quotient, remainder = divmod(self.to_sec(), other.to_sec())
        return int(quotient), self.from_sec(remainder)


class Time(TVal):
    """A point in time, since the epoch or, when simulated, since the start. Raises TypeError if negative."""

    __slots__ = ["secs", "nsecs"]

    def __init__(self, secs: float = 0, nsecs: float = 0) -> None:
        super().__init__(secs, nsecs)
        if self.secs < 0:
            raise TypeError("time values must be positive")

    def __repr__(self) -> str:
        return f"genpy.Time[{self.to_nsec()}]"

    def __add__(self: M, other: Duration) -> M:
        return self._checked(self.to_nsec() + other.to_nsec()) if isinstance(other, Duration) else NotImplemented

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        if isinstance(other, Time):
            return Duration._of(self.to_nsec() - other.to_nsec())
        return self._checked(self.to_nsec() - other.to_nsec()) if isinstance(other, Duration) else NotImplemented

    @classmethod
    def _checked(cls: type[M], ns: int) -> M:
        if ns >= 0:
            return cls._of(ns)
        try:
            return cls(0, ns)
        except TypeError as error:
            error.add_note(BEGINS_AT_0)
            raise

    def to_time(self) -> float:
        """The value in seconds, as of ``time.time()``."""
        return self.to_sec()


def _split(seconds: float) -> tuple[int, int]:
    secs = int(seconds)
    return secs, int((seconds - secs) * 1_000_000_000)


TVal._comparable, Duration._comparable, Time._comparable = TVal, Duration, Time

rostime = sys.modules[__name__]  # where genpy has them
