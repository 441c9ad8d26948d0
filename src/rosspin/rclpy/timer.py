"""Timers and Rates (sources: rclpy/timer.py, rcl/timer.c)."""

from __future__ import annotations

import inspect
import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from types import CodeType
from typing import Any, NamedTuple

from ..clocks.frames import Place, Trail, asleep_in_loop
from .callback_groups import CallbackGroup
from .clock import Clock, ROSClock
from .context import Context, get_default_context
from .exceptions import RCLError, ROSInterruptException, invalid_context, not_accepted
from .handle import Held
from .time import Time
from .waits import waiting_for

__all__ = ["Rate", "Timer", "TimerInfo"]


_LEAST_PERIOD = 1_000  # ns; a timer with a shorter one keeps no grid
_CALL = 100_000  # ns from one call of such a timer to the next, about what a real machine takes


# What an executor should call, with which arguments, and for a tick its place in the log and when it began (ns).
Call = tuple[Any, tuple[Any, ...], tuple[int, int] | None]


class TimerInfo(NamedTuple):
    """When a call was due, and when it came. A callback with a parameter annotated as TimerInfo is passed it.

    A real ROS 2 has it from Kilted on.
    """

    expected_call_time: Time
    actual_call_time: Time


class Timer(Held):
    """Lets an executor call ``callback()`` every ``timer_period_ns``, for the first time after one period.

    The next call is due one period after this one was due. If that has passed when this call begins, the next one takes
    the next place of the same grid: however long callbacks take, at most one call comes late, and the grid is kept.
    Without ``autostart`` it begins with ``reset``. Raises RCLError if the period is negative or the context not valid.
    """

    def __init__(
        self,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None,
        timer_period_ns: int,
        clock: Clock,
        *,
        context: Context | None = None,
        autostart: bool = True,
    ) -> None:
        if timer_period_ns < 0:
            raise RCLError("failed to create timer: timer period must be non-negative")
        if timer_period_ns >= 2**63:
            signature = (
                "Timer(arg0: rclpy::Clock, arg1: rclpy._rclpy_pybind11.Context, arg2: typing.SupportsInt, arg3: bool)"
            )
            raise not_accepted(signature, "Clock", "Context", timer_period_ns, autostart)
        if not (context or get_default_context()).ok():
            raise invalid_context("create timer")
        self.callback_group: Any = callback_group
        self._clock = clock
        self._rosspin_period = timer_period_ns
        self._rosspin_last = clock._rosspin_ns()
        self._rosspin_next = self._rosspin_last + timer_period_ns
        self._rosspin_credit: int | None = None  # what is left of the period while the source of ROS time changes
        self._rosspin_cancelled = not autostart
        self._rosspin_expected = self._rosspin_next  # when the last call was due
        self._rosspin_nudge: Callable[[], None] | None = None  # tells the waiting executor
        self._executor_event = False
        world = clock._rosspin_state.world
        self._rosspin_ticks = world.recording.log if callback is not None else None
        self._rosspin_count = 0
        if self._rosspin_ticks is not None:
            self._rosspin_source = world.source(getattr(callback, "__name__", type(callback).__name__))
            self._rosspin_ticks.timers.add(self)
            if timer_period_ns >= _LEAST_PERIOD:
                self._rosspin_ticks.periods.setdefault(self._rosspin_source, timer_period_ns)
        self.callback = callback
        if isinstance(clock, ROSClock):
            clock._rosspin_timers[self] = None

    @property
    def clock(self) -> Clock:
        """The clock that it goes by."""
        return self._clock

    @property
    def callback(self) -> Any:
        """The function that is called."""
        return self._rosspin_callback

    @callback.setter
    def callback(self, callback: Callable[..., Any] | None) -> None:
        self._rosspin_callback = callback
        self._rosspin_wants_info = False
        if callback is not None:
            try:
                parameters = inspect.signature(callback).parameters.values()
            except (TypeError, ValueError):
                return
            self._rosspin_wants_info = any(parameter.annotation is TimerInfo for parameter in parameters)

    @property
    def timer_period_ns(self) -> int:
        """The period. A new one does not move the next call: it counts from there on."""
        self._rosspin_check()
        return self._rosspin_period

    @timer_period_ns.setter
    def timer_period_ns(self, value: float) -> None:
        self._rosspin_check()
        self._rosspin_period = int(value)
        self._rosspin_moved()

    def is_ready(self) -> bool:
        """Whether a call is due."""
        self._rosspin_check()
        return self._rosspin_is_due()

    def is_canceled(self) -> bool:
        """Whether it is cancelled."""
        self._rosspin_check()
        return self._rosspin_cancelled

    def cancel(self) -> None:
        """Call no more, until ``reset``."""
        self._rosspin_check()
        self._clock._rosspin_state.world.await_spin(-(self.callback is not None and not self._rosspin_cancelled))
        self._rosspin_cancelled = True

    def reset(self) -> None:
        """Begin again, even if cancelled: the next call is due after one period."""
        self._rosspin_check()
        self._rosspin_next = self._clock._rosspin_ns() + self._rosspin_period
        self._rosspin_cancelled = False
        self._rosspin_moved()
        if self._rosspin_nudge:
            self._rosspin_nudge()

    def time_since_last_call(self) -> int:
        """How long ago (ns) it was called, or made if it was never called."""
        self._rosspin_check()
        return self._clock._rosspin_ns() - self._rosspin_last

    def time_until_next_call(self) -> int | None:
        """How long (ns) until it is due, negative if it is overdue; None if it is cancelled."""
        self._rosspin_check()
        return None if self._rosspin_cancelled else self._rosspin_next - self._clock._rosspin_ns()

    def destroy(self) -> None:
        """Destroy it. A second call does nothing."""
        self._rosspin_destroyed = True
        if isinstance(self._clock, ROSClock):
            self._clock._rosspin_timers.pop(self, None)

    def _rosspin_take(self) -> Call | None:
        """Return the call to make now; None if it was destroyed. Raises RCLError if it was cancelled once ready."""
        if self._rosspin_destroyed:
            return None
        if self._rosspin_cancelled:
            raise RCLError("failed to call timer: timer is canceled")
        now = self._rosspin_last = self._clock._rosspin_ns()
        expected = self._rosspin_expected = self._rosspin_next
        following = expected + self._rosspin_period
        if 0 <= self._rosspin_period < _LEAST_PERIOD:
            following = now + _CALL
        elif following <= now:
            # On to the next place of the grid.
            following = now + self._rosspin_period - (now - expected) % self._rosspin_period
        self._rosspin_next = following
        tick = None
        if self._rosspin_ticks is not None:
            self._rosspin_count += 1
            began = self._rosspin_stamp(now)
            due = self._rosspin_stamp(expected)
            tick = self._rosspin_ticks.add(self._rosspin_source, self._rosspin_count, due, began), began
        return self._rosspin_callback, self._rosspin_info(expected, now) if self._rosspin_wants_info else (), tick

    def _rosspin_info(self, expected: int, now: int) -> tuple[TimerInfo]:
        kind = self._clock.clock_type
        return (TimerInfo(Time(nanoseconds=expected, clock_type=kind), Time(nanoseconds=now, clock_type=kind)),)

    def _rosspin_stamp(self, ns: int) -> int:
        """Return a time of this timer's clock as it is recorded: on the run's clock, unless /clock tells ROS time."""
        return ns - self._clock._rosspin_ahead() if self._clock._rosspin_flows else ns

    def _rosspin_in_run(self) -> int:
        """Return the present time as it is recorded."""
        return self._rosspin_stamp(self._clock._rosspin_ns())

    # --- what executors ask, even of a destroyed timer ----------------------------------------------------------------

    def _rosspin_end(self, tick: tuple[int, int]) -> None:
        """Record that a call has ended now."""
        if self._rosspin_ticks is not None:
            place, began = tick
            self._rosspin_ticks.end(place, self._rosspin_in_run() - began)

    def _rosspin_coming(self) -> list[tuple[str, int, int, int]]:
        """The next calls: see ``world.graph.Ticking``."""
        return [
            (self._rosspin_source, self._rosspin_count + n, due, real)
            for n, (due, real) in enumerate(self._rosspin_next_calls(), 1)
        ]

    def _rosspin_next_calls(self) -> list[tuple[int, int]]:
        """When they are due, and when they would come, as they are recorded."""
        if not self._rosspin_is_flowing() or self._rosspin_period < _LEAST_PERIOD:
            return []
        due, now = self._rosspin_next, self._clock._rosspin_ns()
        calls = [(due, max(due, now))]
        if due <= now:
            following = now + self._rosspin_period - (now - due) % self._rosspin_period
            calls.append((following, following))
        return [(self._rosspin_stamp(due), self._rosspin_stamp(real)) for due, real in calls]

    def _rosspin_moved(self) -> None:
        """Note that the calls are no longer due on the grid of the first ones."""
        if self._rosspin_ticks is not None:
            self._rosspin_ticks.periods[self._rosspin_source] = 0

    def _rosspin_is_due(self) -> bool:
        """Whether a call is due."""
        return (
            self._rosspin_next <= self._clock._rosspin_ns()
            and not self._rosspin_cancelled
            and not self._rosspin_destroyed
        )

    def _rosspin_is_flowing(self) -> bool:
        """Whether it becomes due just by waiting."""
        return self._clock._rosspin_flows and not self._rosspin_cancelled and not self._rosspin_destroyed

    def _rosspin_time_left(self) -> int:
        """How long (ns) until it is due."""
        return self._rosspin_next - self._clock._rosspin_ns()

    # --- ROS time that jumps ------------------------------------------------------------------------------------------

    def _rosspin_before_switch(self) -> None:
        """Keep what is left of the period: ROS time is about to switch to another source."""
        now = self._clock._rosspin_ns()
        if now or self._clock._rosspin_flows:  # 0: no one has told the time yet
            self._rosspin_credit = self._rosspin_next - now

    def _rosspin_after_switch(self) -> None:
        """Continue with what was left of the period, on the time of the new source."""
        now = self._clock._rosspin_ns()
        if self._rosspin_credit is not None and (now or self._clock._rosspin_flows):
            self._rosspin_next, self._rosspin_last = (
                now - self._rosspin_credit + self._rosspin_period,
                now - self._rosspin_credit,
            )
            self._rosspin_credit = None
            self._rosspin_moved()

    def _rosspin_after_jump(self) -> None:
        """Begin again if ROS time went back before the last call: the next call is due after one period."""
        now = self._clock._rosspin_ns()
        if self._rosspin_next > now and now < self._rosspin_last:
            self._rosspin_next, self._rosspin_last = now + self._rosspin_period, now
            self._rosspin_moved()


class Rate:
    """Sleeps in a loop so that its passes begin at a fixed rate. Made by ``Node.create_rate``.

    A timer wakes whoever sleeps, so another thread has to spin, or the sleep has no end. If a pass takes too long, one
    ``sleep`` returns immediately; then the grid continues.
    """

    def __init__(self, timer: Timer, *, context: Context) -> None:
        self._timer = timer
        self._event = threading.Event()
        self._lock = threading.Lock()
        self._num_sleepers = 0
        self._is_shutdown = False
        self._is_destroyed = False
        timer.callback = self._rosspin_wake
        context.on_shutdown(self._on_shutdown)

        self._rosspin_world = timer.clock._rosspin_state.world
        self._rosspin_source = ""
        self._rosspin_passes = 0
        self._rosspin_due = self._rosspin_expected = self._rosspin_pass_start = timer._rosspin_in_run()
        self._rosspin_slept: tuple[int, CodeType, int]  # in which thread and where in its code

    def _rosspin_wake(self) -> None:
        if not self._event.is_set():
            self._rosspin_due = self._timer._rosspin_stamp(self._timer._rosspin_expected)
        self._event.set()

    def _on_shutdown(self) -> None:
        self._is_shutdown = True
        self.destroy()

    def destroy(self) -> None:
        """Wake whoever sleeps, and let no one sleep any more."""
        self._is_destroyed = True
        self._event.set()

    def sleep(self) -> None:
        """Sleep until the timer wakes it; return immediately if it did since the last ``sleep``.

        A signal does not wake it. Raises ROSInterruptException at ``rclpy.shutdown()``, RuntimeError if destroyed.
        """
        if self._is_shutdown:
            raise ROSInterruptException()
        if self._is_destroyed:
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
        self._rosspin_record_pass()
        with self._lock:
            self._num_sleepers += 1
        try:
            if not self._event.is_set():
                with waiting_for(self._timer, self._rosspin_world):
                    self._event.wait()
        finally:
            with self._lock:
                self._num_sleepers -= 1
                if self._num_sleepers == 0:
                    self._event.clear()
        if self._is_shutdown:
            raise ROSInterruptException()
        self._rosspin_expected, self._rosspin_pass_start = self._rosspin_due, self._timer._rosspin_in_run()

    def _rosspin_record_pass(self) -> None:
        ticks = self._rosspin_world.recording.log
        if ticks is not None:
            if not self._rosspin_source:
                self._rosspin_source = self._rosspin_world.source("Rate")
                ticks.periods[self._rosspin_source] = self._timer.timer_period_ns
                ticks.rates.add(self)
            self._rosspin_passes += 1
            duration = self._timer._rosspin_in_run() - self._rosspin_pass_start
            ticks.add(
                self._rosspin_source, self._rosspin_passes, self._rosspin_expected, self._rosspin_pass_start, duration
            )
            loop = sys._getframe(2)
            self._rosspin_slept = threading.get_ident(), loop.f_code, loop.f_lasti

    def _rosspin_coming(self, trails: Mapping[int, Trail]) -> list[tuple[str, int, int, int]]:
        """The next passes: see ``world.graph.Looping``.

        What the timer was due to wake while a pass continued is one pass, which begins late: the others are lost.
        """
        thread, code, call = self._rosspin_slept
        is_asleep = asleep_in_loop(trails.get(thread, []), code, call)
        if is_asleep is None or self._is_destroyed:
            return []
        begun = [] if is_asleep else [(self._rosspin_expected, self._rosspin_pass_start)]
        woken = [(self._rosspin_due, self._timer._rosspin_in_run())] if self._event.is_set() else []
        passes = [*begun, *woken, *self._timer._rosspin_next_calls()]
        return [(self._rosspin_source, self._rosspin_passes + n, due, real) for n, (due, real) in enumerate(passes, 1)]


_SLEEP = Rate.sleep.__code__


def is_asleep_on_a_rate(places: Iterable[Place]) -> bool:
    """Whether a thread whose stack is at these places sleeps on a Rate."""
    return any((place.filename, place.function) == (_SLEEP.co_filename, _SLEEP.co_qualname) for place in places)
