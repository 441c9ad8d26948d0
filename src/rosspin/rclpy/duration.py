"""Duration (source: rclpy/duration.py)."""

from __future__ import annotations

from functools import total_ordering
from importlib import import_module
from typing import Any

from ..clocks.clock import NS

__all__ = ["Duration", "Infinite"]


@total_ordering
class Ordered:
    """A value that is compared by its ``nanoseconds``, and only with its own kind."""

    _rosspin_ns: int

    @property
    def nanoseconds(self) -> int:
        """Its whole length, or time."""
        return self._rosspin_ns

    def _rosspin_other(self, other: object) -> int | None:
        """Return the nanoseconds to compare with; None if ``other`` is of another kind."""
        return other.nanoseconds if isinstance(other, type(self)) else None

    def __eq__(self, other: object) -> bool:
        ns = self._rosspin_other(other)
        return NotImplemented if ns is None else self.nanoseconds == ns

    def __lt__(self, other: object) -> bool:
        ns = self._rosspin_other(other)
        return NotImplemented if ns is None else self.nanoseconds < ns

    __hash__ = None  # type: ignore[assignment]


class Held:
    """Base of what holds an object of the C part: it can be copied, but neither deeply nor by pickle."""

    _rosspin_held: str  # the name of its class; with a module if that is another

    def __copy__(self) -> Any:
        copied = object.__new__(type(self))
        vars(copied).update(vars(self))
        return copied

    def __reduce_ex__(self, protocol: Any) -> Any:
        held = self._rosspin_held
        raise TypeError(f"cannot pickle '{held if '.' in held else f'rclpy._rclpy_pybind11.{held}'}' object")


class Duration(Held, Ordered):
    """A length of time: seconds (with their fraction) plus nanoseconds. Raises OverflowError beyond 292 years."""

    _rosspin_held = "rcl_duration_t"

    def __init__(self, *, seconds: float = 0, nanoseconds: int = 0) -> None:
        total = int(seconds * NS) + int(nanoseconds)
        if not -(2**63) <= total < 2**63:
            raise OverflowError("Total nanoseconds value is too large to store in C duration.")
        self._rosspin_ns = total

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self.nanoseconds})"

    def __str__(self) -> str:
        return "Infinite" if self == Infinite else f"{self.nanoseconds} nanoseconds"

    def to_msg(self) -> Any:
        """Return the duration as a message, builtin_interfaces/Duration."""
        seconds, nanoseconds = divmod(self.nanoseconds, NS)
        return import_module("builtin_interfaces.msg").Duration(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any) -> Duration:
        """Make a Duration from a message. Raises TypeError for any other message."""
        if not isinstance(msg, import_module("builtin_interfaces.msg").Duration):
            raise TypeError("Must pass a builtin_interfaces.msg.Duration object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)


Infinite = Duration(nanoseconds=2**63 - 1)
