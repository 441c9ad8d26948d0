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


# What an executor is to call, with which arguments, and for a tick its place in the log and when it began (ns).
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
        self.clock = clock
        self._period = timer_period_ns
        self._last = clock.ns()
        self._next = self._last + timer_period_ns
        self._credit: int | None = None  # what is left of the period while the source of ROS time changes
        self._cancelled = not autostart
        self.expected = self._next  # when the last call was due
        self.nudge: Callable[[], None] | None = None  # tells the waiting executor
        self._executor_event = False
        world = clock._state.world
        self._ticks = world.recording.log if callback is not None else None
        self._count = 0
        if self._ticks is not None:
            self.source = world.source(getattr(callback, "__name__", type(callback).__name__))
            self._ticks.timers.add(self)
            if timer_period_ns >= _LEAST_PERIOD:
                self._ticks.periods.setdefault(self.source, timer_period_ns)
        self.callback = callback
        if isinstance(clock, ROSClock):
            clock.timers[self] = None

    @property
    def callback(self) -> Any:
        """The function that is called."""
        return self._callback

    @callback.setter
    def callback(self, callback: Callable[..., Any] | None) -> None:
        self._callback = callback
        self._wants_info = False
        if callback is not None:
            try:
                parameters = inspect.signature(callback).parameters.values()
            except (TypeError, ValueError):
                return
            self._wants_info = any(parameter.annotation is TimerInfo for parameter in parameters)

    @property
    def timer_period_ns(self) -> int:
        """The period. A new one does not move the next call: it counts from there on."""
        self._check()
        return self._period

    @timer_period_ns.setter
    def timer_period_ns(self, value: float) -> None:
        self._check()
        self._period = int(value)
        self._moved()

    def is_ready(self) -> bool:
        """Whether a call is due."""
        self._check()
        return self.is_due()

    def is_canceled(self) -> bool:
        """Whether it is cancelled."""
        self._check()
        return self._cancelled

    def cancel(self) -> None:
        """Call no more, until ``reset``."""
        self._check()
        self._cancelled = True

    def reset(self) -> None:
        """Begin anew, even if cancelled: the next call is due after one period."""
        self._check()
        self._next = self.clock.ns() + self._period
        self._cancelled = False
        self._moved()
        if self.nudge:
            self.nudge()

    def time_since_last_call(self) -> int:
        """How long ago (ns) it was called, or made if it was never called."""
        self._check()
        return self.clock.ns() - self._last

    def time_until_next_call(self) -> int | None:
        """How long (ns) until it is due, negative if it is overdue; None if it is cancelled."""
        self._check()
        return None if self._cancelled else self._next - self.clock.ns()

    def destroy(self) -> None:
        """Destroy it."""
        self._check()
        self._destroyed = True
        if isinstance(self.clock, ROSClock):
            self.clock.timers.pop(self, None)

    def take(self) -> Call | None:
        """Return the call to make now; None if it was destroyed. Raises RCLError if it was cancelled once ready."""
        if self._destroyed:
            return None
        if self._cancelled:
            raise RCLError("failed to call timer: timer is canceled")
        now = self._last = self.clock.ns()
        expected = self.expected = self._next
        following = expected + self._period
        if 0 <= self._period < _LEAST_PERIOD:
            following = now + _CALL
        elif following <= now:
            # On to the next place of the grid.
            following = now + self._period - (now - expected) % self._period
        self._next = following
        tick = None
        if self._ticks is not None:
            self._count += 1
            began = self.in_run()
            tick = self._ticks.add(self.source, self._count, expected + began - now, began), began
        return self._callback, self._info(expected, now) if self._wants_info else (), tick

    def _info(self, expected: int, now: int) -> tuple[TimerInfo]:
        kind = self.clock.clock_type
        return (TimerInfo(Time(nanoseconds=expected, clock_type=kind), Time(nanoseconds=now, clock_type=kind)),)

    def stamp(self, ns: int) -> int:
        """Return a time of this timer's clock as it is recorded: on the run's clock, unless /clock tells ROS time."""
        return ns + self.clock._state.clock.now() - self.clock.ns() if self.clock.flows else ns

    def in_run(self) -> int:
        """Return the present time as it is recorded."""
        clock = self.clock
        return clock._state.clock.now() if clock.flows else clock.ns()

    # --- what executors ask, even of a destroyed timer ----------------------------------------------------------------

    def end(self, tick: tuple[int, int]) -> None:
        """Record that a call has ended now."""
        if self._ticks is not None:
            place, began = tick
            self._ticks.end(place, self.in_run() - began)

    def coming(self) -> list[tuple[str, int, int, int]]:
        """The next calls: see ``world.graph.Ticking``."""
        return [(self.source, self._count + n, due, real) for n, (due, real) in enumerate(self.next_calls(), 1)]

    def next_calls(self) -> list[tuple[int, int]]:
        """When they are due, and when they would come, as they are recorded."""
        if not self.is_flowing() or self._period < _LEAST_PERIOD:
            return []
        due, now = self._next, self.clock.ns()
        calls = [(due, max(due, now))]
        if due <= now:
            following = now + self._period - (now - due) % self._period
            calls.append((following, following))
        return [(self.stamp(due), self.stamp(real)) for due, real in calls]

    def _moved(self) -> None:
        """Note that the calls are no longer due on the grid of the first ones."""
        if self._ticks is not None:
            self._ticks.periods[self.source] = 0

    def is_due(self) -> bool:
        """Whether a call is due."""
        return self._next <= self.clock.ns() and not self._cancelled and not self._destroyed

    def is_flowing(self) -> bool:
        """Whether it becomes due just by waiting."""
        return self.clock.flows and not self._cancelled and not self._destroyed

    def time_left(self) -> int:
        """How long (ns) until it is due."""
        return self._next - self.clock.ns()

    # --- ROS time that jumps ------------------------------------------------------------------------------------------

    def before_switch(self) -> None:
        """Keep what is left of the period: ROS time is about to switch to another source."""
        now = self.clock.ns()
        if now or self.clock.flows:  # 0: nobody has told the time yet
            self._credit = self._next - now

    def after_switch(self) -> None:
        """Go on with what was left of the period, on the time of the new source."""
        now = self.clock.ns()
        if self._credit is not None and (now or self.clock.flows):
            self._next, self._last = now - self._credit + self._period, now - self._credit
            self._credit = None
            self._moved()

    def after_jump(self) -> None:
        """Begin anew if ROS time went back before the last call: the next call is due after one period."""
        now = self.clock.ns()
        if self._next > now and now < self._last:
            self._next, self._last = now + self._period, now
            self._moved()


class Rate:
    """Sleeps in a loop so that its passes begin at a fixed rate. Made by ``Node.create_rate``.

    A timer wakes whoever sleeps, so another thread has to spin, or the sleep lasts for ever. If a pass takes too long,
    one ``sleep`` returns immediately; then the grid goes on.
    """

    def __init__(self, timer: Timer, *, context: Context) -> None:
        self._timer = timer
        self._event = threading.Event()
        self._lock = threading.Lock()
        self._sleepers = 0
        self._is_shutdown = False
        self._is_destroyed = False
        timer.callback = self._wake
        context.on_shutdown(self._on_shutdown)

        self._world = timer.clock._state.world
        self._source = ""
        self._passes = 0
        self._due = self._expected = self._pass_start = timer.in_run()
        self._slept: tuple[int, CodeType, int]  # in which thread and where in its code

    def _wake(self) -> None:
        if not self._event.is_set():
            self._due = self._timer.stamp(self._timer.expected)
        self._event.set()

    def _on_shutdown(self) -> None:
        self._is_shutdown = True
        self.destroy()

    def destroy(self) -> None:
        """Wake whoever sleeps, and let nobody sleep any more."""
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
        self._record_pass()
        with self._lock:
            self._sleepers += 1
        try:
            if not self._event.is_set():
                with waiting_for(self._timer, self._world):
                    self._event.wait()
        finally:
            with self._lock:
                self._sleepers -= 1
                if self._sleepers == 0:
                    self._event.clear()
        if self._is_shutdown:
            raise ROSInterruptException()
        self._expected, self._pass_start = self._due, self._timer.in_run()

    def _record_pass(self) -> None:
        ticks = self._world.recording.log
        if ticks is not None:
            if not self._source:
                self._source = self._world.source("Rate")
                ticks.periods[self._source] = self._timer.timer_period_ns
                ticks.rates.add(self)
            self._passes += 1
            duration = self._timer.in_run() - self._pass_start
            ticks.add(self._source, self._passes, self._expected, self._pass_start, duration)
            loop = sys._getframe(2)
            self._slept = threading.get_ident(), loop.f_code, loop.f_lasti

    def coming(self, trails: Mapping[int, Trail]) -> list[tuple[str, int, int, int]]:
        """The next passes: see ``world.graph.Looping``.

        What the timer was due to wake while a pass went on is one pass, which begins late: the others are lost.
        """
        thread, code, call = self._slept
        is_asleep = asleep_in_loop(trails.get(thread, []), code, call)
        if is_asleep is None or self._is_destroyed:
            return []
        begun = [] if is_asleep else [(self._expected, self._pass_start)]
        woken = [(self._due, self._timer.in_run())] if self._event.is_set() else []
        passes = [*begun, *woken, *self._timer.next_calls()]
        return [(self._source, self._passes + n, due, real) for n, (due, real) in enumerate(passes, 1)]


_SLEEP = Rate.sleep.__code__


def is_asleep_on_a_rate(places: Iterable[Place]) -> bool:
    """Whether a thread whose stack is at these places sleeps on a Rate."""
    return any((place.filename, place.function) == (_SLEEP.co_filename, _SLEEP.co_qualname) for place in places)
