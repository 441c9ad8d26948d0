"""Clocks (source: rclpy/clock.py)."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..world.world import NotSimulated
from .context import Context, get_default_context
from .duration import Duration
from .exceptions import NotInitializedException
from .state import Gate, state
from .time import ClockType, Time

if TYPE_CHECKING:
    from .timer import Timer

__all__ = ["Clock", "ClockType", "ROSClock"]


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
        self.ns: Callable[[], int] = self._state.clock.system
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

    def create_jump_callback(self, *args: Any, **kwargs: Any) -> Any:
        """Raises NotSimulated."""
        raise NotSimulated("Clock.create_jump_callback")

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
        if self.clock_type is not ClockType.STEADY_TIME:
            own.sleepers.append(gate)
        deaf = threading.current_thread() is threading.main_thread()
        own.asleep = own.asleep or deaf
        try:
            while not stopped and self.changes == changes and (left := until.nanoseconds - self.ns()) > 0:
                gate.wait(left if self.flows else None)
        finally:
            context.forget(stop)
            self.watchers.remove(gate)
            if self.clock_type is not ClockType.STEADY_TIME:
                own.sleepers.remove(gate)
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
            for timer in timers:
                timer.before_switch()
            self.flows = not enabled
            self.changes += 1
            self.ns = (lambda: self._told) if enabled else self._state.clock.system
            for timer in timers:
                timer.after_switch()
            self._open_gates()

    def set_ros_time_override(self, time: Time) -> None:
        """Set the time. Raises TypeError for what is no Time."""
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")
        self._told = time.nanoseconds
        if self.ros_time_is_active:
            for timer in list(self.timers):
                timer.after_jump()
            self._open_gates()

    def _open_gates(self) -> None:
        for gate in list(self.watchers):
            gate.open()
