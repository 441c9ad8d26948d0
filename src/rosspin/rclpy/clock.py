"""Clocks (source: rclpy/clock.py)."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING

from .context import Context, get_default_context
from .duration import Duration
from .exceptions import NotInitializedException
from .state import Gate, state
from .time import ClockType, Time

if TYPE_CHECKING:
    from .timer import Timer

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


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

    def __repr__(self) -> str:
        return f"Clock(clock_type={self.clock_type.name})"

    def now(self) -> Time:
        """The time."""
        return Time(nanoseconds=self.ns(), clock_type=self.clock_type)

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], object] | None = None,
        post_callback: Callable[[TimeJump], object] | None = None,
    ) -> JumpHandle:
        """Call functions before and after the time jumps by more than a threshold, which only ROS time does."""
        return JumpHandle(self, threshold, pre_callback, post_callback)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Sleep until a time of this clock; whether it was reached, and not the context shut down meanwhile.

        A signal does not wake it: the rest of the program learns of it afterwards. Raises ValueError for the time of
        another kind of clock, NotInitializedException if the context is not valid.
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
        """``sleep_until(now() + rel_time)``."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """ROS time: the system's, unless it is told, as by /clock."""

    def __new__(cls) -> ROSClock:
        return object.__new__(cls)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME)
        self._told = 0
        self.handles: list[JumpHandle] = []
        self.timers: dict[Timer, None] = {}  # those that go by it

    @property
    def ros_time_is_active(self) -> bool:
        """Whether it is told the time."""
        return not self.flows

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self.flows:
            change = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
            then = self._told if enabled else self._state.clock.now()
            self._jump(change, then - self.ns(), lambda: self._switch(enabled))

    def _switch(self, enabled: bool) -> None:
        self.flows = not enabled
        self.changes += 1
        self.ns = (lambda: self._told) if enabled else self._state.clock.now

    def set_ros_time_override(self, time: Time) -> None:
        """Tell it the time. TypeError for what is no Time."""
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")

        def tell() -> None:
            self._told = time.nanoseconds

        if self.ros_time_is_active:
            self._jump(ClockChange.ROS_TIME_NO_CHANGE, time.nanoseconds - self._told, tell)
        else:
            tell()

    def _jump(self, change: ClockChange, delta: int, jump: Callable[[], None]) -> None:
        handles = [handle for handle in self.handles if handle.is_meant(change, delta)]
        switches = change is not ClockChange.ROS_TIME_NO_CHANGE
        timers = list(self.timers)
        for handle in handles:
            if handle.pre_callback:
                handle.pre_callback()
        for timer in timers:
            timer.before_jump(switches)
        jump()
        for timer in timers:
            timer.after_jump(switches)
        for handle in handles:
            if handle.post_callback:
                handle.post_callback(TimeJump(change, Duration(nanoseconds=delta)))
        for gate in list(self.watchers):
            gate.open()


class ClockChange(IntEnum):
    """What happened to the source of ROS time."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class TimeJump:
    """A jump of time: whether its source changed, and by how much it jumped."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self.clock_change = clock_change
        self.delta = delta


class JumpThreshold:
    """Which jumps count: forward by at least ``min_forward`` (above 0), backward by ``min_backward`` (below 0)."""

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


class JumpHandle:
    """Functions that a clock calls when its time jumps; as a context manager, within it."""

    def __init__(
        self,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], object] | None,
        post_callback: Callable[[TimeJump], object] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        self.pre_callback = pre_callback
        self.post_callback = post_callback
        self._threshold = threshold
        self._clock: Clock | None = clock
        if isinstance(clock, ROSClock):
            clock.handles.append(self)

    def is_meant(self, change: ClockChange, delta: int) -> bool:
        """Whether a jump (ns) counts."""
        if change is not ClockChange.ROS_TIME_NO_CHANGE:
            return self._threshold.on_clock_change
        forward, backward = self._threshold.min_forward, self._threshold.min_backward
        return (forward is not None and delta >= forward.nanoseconds) or (
            backward is not None and delta <= backward.nanoseconds
        )

    def unregister(self) -> None:
        """Call them no more."""
        if isinstance(self._clock, ROSClock):
            self._clock.handles.remove(self)
        self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *error: object) -> None:
        self.unregister()
