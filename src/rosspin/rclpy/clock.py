"""Clocks (source: rclpy/clock.py)."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum, IntEnum
from typing import Any
from weakref import WeakKeyDictionary

from .context import Context, get_default_context, state
from .duration import Duration, Held
from .event import Event
from .exceptions import NotInitializedException
from .handle import Handle
from .time import ClockType, Time

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


class ClockChange(IntEnum):
    """Whether a jump comes from another source of ROS time, by number."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4

    # As those that come with a jump are printed.
    __str__ = Enum.__str__
    __format__ = Enum.__format__


class JumpThreshold:
    """Of which jumps someone wants to be told: of at least this much forward, or back, and of changes of the source.

    Raises ValueError if the one is not above 0, if the other is not below, and if there is neither, nor a change.
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

    def _rosspin_is_met(self, jump: TimeJump) -> bool:
        delta = jump.delta
        return (
            (self.on_clock_change and jump.clock_change is not ClockChange.ROS_TIME_NO_CHANGE)
            or (self.min_backward is not None and delta <= self.min_backward)
            or (self.min_forward is not None and delta >= self.min_forward)
        )


class TimeJump:
    """A jump of ROS time: by how much, and whether its source has changed. Raises TypeError for what is no change."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """Whether its source has changed."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """By how much it jumps: negative for back, 0 for a change of the source."""
        return self._delta


class JumpHandle:
    """Who is told of a clock's jumps. Made by ``Clock.create_jump_callback``; a ``with`` block ends with unregister.

    Raises ValueError if there is nothing that can be called.
    """

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], Any] | None,
        post_callback: Callable[[TimeJump], Any] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        if pre_callback is not None and not callable(pre_callback):
            raise ValueError("pre_callback must be callable if given")
        if post_callback is not None and not callable(post_callback):
            raise ValueError("post_callback must be callable if given")
        self._clock: Clock | None = clock
        threshold.min_forward  # noqa: B018 - AttributeError for what is no threshold
        self._rosspin_threshold = threshold
        self._pre_callback = pre_callback
        self._post_callback = post_callback
        clock._rosspin_jump_handles.append(self)

    def _rosspin_before(self, jump: TimeJump) -> None:
        """Call what should be called before a jump, if the threshold is met."""
        if self._pre_callback and self._rosspin_threshold._rosspin_is_met(jump):
            self._pre_callback()

    def _rosspin_after(self, jump: TimeJump) -> None:
        """Call what should be called after it."""
        if self._post_callback and self._rosspin_threshold._rosspin_is_met(jump):
            self._post_callback(jump)

    def unregister(self) -> None:
        """Tell nothing any more. A second call does nothing."""
        if self._clock is not None:
            self._clock._rosspin_jump_handles.remove(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *error: object) -> None:
        self.unregister()


class _Held:
    def check(self) -> None:
        """Find nothing wrong: a clock is never destroyed."""


_HELD = _Held()


class Clock(Held):
    """Tells the time: the system's, a steady one (in simulated time they are the same), or ROS's, a ROSClock."""

    _rosspin_held = "Clock"

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        return object.__new__(ROSClock if clock_type is ClockType.ROS_TIME else cls)

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self._clock_type = clock_type
        self._rosspin_state = state()
        # The time in ns: looked up once, as each tick asks several times.
        clock = self._rosspin_state.clock
        self._rosspin_ns: Callable[[], int] = clock.system
        self._rosspin_ahead: Callable[[], int] = lambda: clock.ahead  # of the run's time
        if clock_type is ClockType.STEADY_TIME:
            self._rosspin_ns = time.monotonic_ns
            ahead = time.monotonic_ns() - clock.now()
            self._rosspin_ahead = lambda: ahead
        self._rosspin_flows = True  # whether its time passes by itself
        self._rosspin_changes = 0  # how often the source of its time has changed
        self._rosspin_watchers: list[Event] = []  # set when the time jumps
        self._rosspin_jump_handles: list[JumpHandle] = []  # who is told of it

    @property
    def clock_type(self) -> ClockType:
        """Which time it tells."""
        return self._clock_type

    @property
    def handle(self) -> Handle:
        """Its handle, which can be held and nothing else."""
        return Handle(_HELD)

    def __repr__(self) -> str:
        return f"Clock(clock_type={self.clock_type.name})"

    def now(self) -> Time:
        """The time."""
        return Time(nanoseconds=self._rosspin_ns(), clock_type=self.clock_type)

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], Any] | None = None,
        post_callback: Callable[[TimeJump], Any] | None = None,
    ) -> JumpHandle:
        """Call ``pre_callback()`` before a jump that meets the threshold, and ``post_callback(jump)`` after it.

        Only ROS time jumps in this way, when /clock tells it or ceases to: no one is told that a system's clock is set.
        Raises ValueError if neither can be called.
        """
        post = post_callback if callable(post_callback) else None
        return JumpHandle(clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post)

    @contextmanager
    def _rosspin_jumping(self, change: ClockChange, delta: int = 0) -> Iterator[None]:
        """Within this context the time jumps, by so many ns. Those who want to be told are told before and after."""
        jump = TimeJump(change, Duration(nanoseconds=delta))
        for handle in list(self._rosspin_jump_handles):
            handle._rosspin_before(jump)
        yield
        for handle in list(self._rosspin_jump_handles):
            handle._rosspin_after(jump)

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
        own, event = self._rosspin_state, Event()
        changes = self._rosspin_changes
        stopped = False

        def stop() -> None:
            nonlocal stopped
            stopped = True
            event.set()

        context.on_shutdown(stop)
        self._rosspin_watchers.append(event)
        if self.clock_type is not ClockType.STEADY_TIME:
            own.sleepers.append(event)
        deaf = threading.current_thread() is threading.main_thread()
        own.asleep = own.asleep or deaf
        try:
            while (
                not stopped
                and self._rosspin_changes == changes
                and (left := until.nanoseconds - self._rosspin_ns()) > 0
            ):
                event.wait(left if self._rosspin_flows else None)
        finally:
            if stop in context._callbacks:
                context._callbacks.remove(stop)
            self._rosspin_watchers.remove(event)
            if self.clock_type is not ClockType.STEADY_TIME:
                own.sleepers.remove(event)
            if deaf:
                own.asleep = False
        if deaf and own.pending:
            handler, own.pending = own.pending, None
            handler()
        return context.ok() and self._rosspin_changes == changes and self._rosspin_ns() >= until.nanoseconds

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Call ``sleep_until(now() + rel_time)``."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """Tells ROS time: the system's, unless another is set, as by /clock."""

    def __new__(cls) -> ROSClock:
        return object.__new__(cls)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=ClockType.ROS_TIME)
        self._rosspin_ros_time = 0
        self._rosspin_timers: WeakKeyDictionary[Any, None] = WeakKeyDictionary()  # the timers that go by this clock

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the time is set from outside."""
        return not self._rosspin_flows

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self._rosspin_flows:
            with self._rosspin_jumping(ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED):
                timers = list(self._rosspin_timers)
                for timer in timers:
                    timer._rosspin_before_switch()
                self._rosspin_flows = not enabled
                self._rosspin_changes += 1
                self._rosspin_ns = (lambda: self._rosspin_ros_time) if enabled else self._rosspin_state.clock.system
                for timer in timers:
                    timer._rosspin_after_switch()
                self._rosspin_set_events()

    def set_ros_time_override(self, time: Time) -> None:
        """Set the time. Raises TypeError for what is no Time."""
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")
        if not self.ros_time_is_active:
            self._rosspin_ros_time = time.nanoseconds
            return
        with self._rosspin_jumping(ClockChange.ROS_TIME_NO_CHANGE, time.nanoseconds - self._rosspin_ros_time):
            self._rosspin_ros_time = time.nanoseconds
            for timer in list(self._rosspin_timers):
                timer._rosspin_after_jump()
            self._rosspin_set_events()

    def _rosspin_set_events(self) -> None:
        for event in list(self._rosspin_watchers):
            event.set()
