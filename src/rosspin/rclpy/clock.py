"""Clocks (source: rclpy/clock.py)."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum, IntEnum
from typing import TYPE_CHECKING, Any

from .context import Context, get_default_context
from .duration import Duration
from .exceptions import NotInitializedException
from .state import Gate, state
from .time import ClockType, Time

if TYPE_CHECKING:
    from .timer import Timer

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


class ClockChange(IntEnum):
    """Whether the source of a clock's time has changed."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class _Told(IntEnum):
    """ClockChange as a callback is told it: the one of the C part, which is printed by its name."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3

    __str__ = Enum.__str__
    __format__ = Enum.__format__


_Told.__name__ = _Told.__qualname__ = "ClockChange"


class JumpThreshold:
    """Which jumps of the time are of interest: forward or backward by at least a duration, a change of its source.

    Raises ValueError unless ``min_forward`` is above 0, ``min_backward`` below 0, and one of the three is given.
    """

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def _is_exceeded(self, change: int, delta: int) -> bool:
        forward, backward = self.min_forward, self.min_backward
        return (
            (self.on_clock_change and change != ClockChange.ROS_TIME_NO_CHANGE)
            or (forward is not None and delta >= forward.nanoseconds)
            or (backward is not None and delta <= backward.nanoseconds)
        )


class TimeJump:
    """A jump: ``clock_change``, and by how much, ``delta``, which is 0 if the source has changed."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, (ClockChange, _Told)):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """Whether the source of the time has changed."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """By how much the time has jumped."""
        return self._delta


class JumpHandle:
    """Two callbacks for a clock's jumps, until ``unregister()``. Raises ValueError for what cannot be called."""

    def __init__(self, *, clock: Clock, threshold: JumpThreshold, pre_callback: Any, post_callback: Any) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        for word, callback in (("pre", pre_callback), ("post", post_callback)):
            if callback is not None and not callable(callback):
                raise ValueError(f"{word}_callback must be callable if given")
        threshold.min_forward  # noqa: B018 - AttributeError for what is no threshold
        self._clock: Clock | None = clock
        self._threshold = threshold
        self._pre_callback = pre_callback
        self._post_callback = post_callback
        clock.jumps.append(self)

    def unregister(self) -> None:
        """Call them no more."""
        if self._clock:
            self._clock.jumps.remove(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *error: object) -> None:
        self.unregister()


class Clock:
    """Tells the time: the system's, a steady one (in simulated time they are the same), or ROS's, a ROSClock."""

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        return object.__new__(ROSClock if clock_type is ClockType.ROS_TIME else cls)

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self.clock_type = clock_type
        self._state = state()
        # The time in ns: looked up once, as each tick asks several times.
        self.ns: Callable[[], int] = self._state.clock.now
        if clock_type is ClockType.STEADY_TIME:
            self.ns = time.monotonic_ns
        self.flows = True  # whether its time goes on by itself
        self.changes = 0  # how often the source of its time has changed
        self.watchers: list[Gate] = []  # opened when the time jumps
        self.jumps: list[JumpHandle] = []

    def __repr__(self) -> str:
        return f"Clock(clock_type={self.clock_type.name})"

    def now(self) -> Time:
        """The time."""
        return Time(nanoseconds=self.ns(), clock_type=self.clock_type)

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], Any] | None = None,
        post_callback: Callable[[TimeJump], Any] | None = None,
    ) -> JumpHandle:
        """Call ``pre_callback()`` before the time jumps, ``post_callback(jump)`` after that. Only ROS time does.

        What a callback raises comes out where the time is set; those after it are not called, and before the jump it
        is then not made. Raises ValueError as JumpHandle does.
        """
        post: Any = None
        if callable(post_callback):

            def post(jump: dict[str, Any]) -> None:
                post_callback(TimeJump(jump["clock_change"], Duration(nanoseconds=jump["delta"])))

        return JumpHandle(clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Sleep until a time of this clock, or until the context is shut down. Return whether the time was reached.

        A signal does not wake it; its handlers run afterwards. Raises ValueError for a time of another kind of clock,
        NotInitializedException if the context is not valid.
        """
        context = context or get_default_context()
        if not context.ok():
            raise NotInitializedException()
        if until.clock_type != self.clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        own, gate = self._state, Gate()
        changes = self.changes
        stopped = False

        def stop() -> None:
            nonlocal stopped
            stopped = True
            gate.open()

        context.on_shutdown(stop)
        self.watchers.append(gate)
        deaf = threading.current_thread() is threading.main_thread()
        own.asleep = own.asleep or deaf
        try:
            while not stopped and self.changes == changes and (left := until.nanoseconds - self.ns()) > 0:
                gate.wait(left if self.flows else None)
        finally:
            context.forget(stop)
            self.watchers.remove(gate)
            if deaf:
                own.asleep = False
        if deaf and own.pending:
            handler, own.pending = own.pending, None
            handler()
        return context.ok() and self.changes == changes and self.ns() >= until.nanoseconds

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Call ``sleep_until(now() + rel_time)``."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """Tells ROS time: the system's, unless another is set, as by /clock."""

    def __new__(cls) -> ROSClock:
        return object.__new__(cls)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME)
        self._told = 0
        self.timers: dict[Timer, None] = {}  # the timers that go by this clock

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the time is set from outside."""
        return not self.flows

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self.flows:
            timers = list(self.timers)
            with self._jumping(_Told.ROS_TIME_ACTIVATED if enabled else _Told.ROS_TIME_DEACTIVATED, 0):
                for timer in timers:
                    timer.before_switch()
                self.flows = not enabled
                self.changes += 1
                self.ns = (lambda: self._told) if enabled else self._state.clock.now
                for timer in timers:
                    timer.after_switch()
                self._open_gates()

    def set_ros_time_override(self, time: Time) -> None:
        """Set the time. Raises TypeError for what is no Time."""
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")
        if not self.ros_time_is_active:
            self._told = time.nanoseconds
            return
        with self._jumping(_Told.ROS_TIME_NO_CHANGE, time.nanoseconds - self._told):
            self._told = time.nanoseconds
            for timer in list(self.timers):
                timer.after_jump()
            self._open_gates()

    @contextmanager
    def _jumping(self, change: _Told, delta: int) -> Iterator[None]:
        """Call what is to be called before a jump, and after it."""
        jumps = [jump for jump in self.jumps if jump._threshold._is_exceeded(change, delta)]
        for jump in jumps:
            if jump._pre_callback:
                jump._pre_callback()
        yield
        for jump in jumps:
            if jump._post_callback:
                jump._post_callback({"clock_change": change, "delta": delta})

    def _open_gates(self) -> None:
        for gate in list(self.watchers):
            gate.open()
