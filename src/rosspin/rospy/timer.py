"""Rate, Timer and sleep (source: rospy/timer.py)."""

from __future__ import annotations

import sys
import threading
import traceback
from collections.abc import Callable, Mapping
from types import CodeType
from typing import Any

from ..clocks.clock import nanoseconds
from ..clocks.frames import Trail, asleep_in_loop, node_frame
from ..messages import genpy
from .exceptions import ROSInterruptException, ROSTimeMovedBackwardsException
from .rostime import Duration, Time
from .state import State, state

__all__ = ["Rate", "Timer", "TimerEvent", "sleep"]


class Rate:
    """Sleeps in a loop so that its passes begin ``hz`` times a second.

    Raises ROSInitException before ``init_node``, ZeroDivisionError if ``hz`` is 0, and TypeError if it is not a number.
    A negative rate never sleeps. With ``reset``, it starts again when ROS time moves backwards, instead of raising.
    """

    def __init__(self, hz: float, reset: bool = False) -> None:
        self._last = state().now()
        self._period = int(1e9 / hz)
        self._reset = reset
        self._source = ""
        self._passes = 0
        self._start = self._pass_start = state().in_run()
        self._slept: tuple[int, CodeType, int]  # in which thread and where in its code

    @property
    def sleep_dur(self) -> Duration:
        """The period."""
        return Duration._of(self._period)

    @sleep_dur.setter
    def sleep_dur(self, period: genpy.Duration) -> None:
        before, self._period = self._period, period.to_nsec()
        self._moved()
        self._start += self._passes * (before - self._period)  # the next pass is still expected when it was

    @property
    def last_time(self) -> Time:
        """When the current period began."""
        return Time._of(self._last)

    @last_time.setter
    def last_time(self, time: genpy.Time) -> None:
        self._last = time.to_nsec()
        self._moved()

    def remaining(self) -> genpy.Duration:
        """How long ``sleep`` would sleep now; negative after an overrun."""
        return Duration._of(self._remaining(state().now()))

    def _remaining(self, now: int) -> int:
        if self._last > now:  # the clock went back
            self._last = now
        return self._period - (now - self._last)

    def sleep(self) -> None:
        """Sleep until the next period begins; return immediately if it has begun already.

        Called at most 3 periods after its pass was due to begin, it makes up for the missed periods by such immediate
        returns. Called later, it gives them up and counts the next period from this call.
        Raises ROSTimeMovedBackwardsException and ROSInterruptException as :func:`sleep` does.
        """
        node = state()
        self._record_pass(node)
        self.wait(node)
        self._pass_start = node.in_run()

    def wait(self, node: State) -> None:
        """Sleep as ``sleep`` does, without recording the pass as a tick."""
        if node.ros_time is None:
            now = node.clock.system()
            last = self._last
            if last > now:
                self._last = last = now
            node.clock.sleep(self._period - (now - last))  # _remaining(now), without the cost of a call
        else:
            now = node.now()
            try:
                _sleep(node, self._remaining(now))
            except ROSTimeMovedBackwardsException:
                if not self._reset:
                    raise
                self._last = node.now()
                self._moved()
                return
        self._last += self._period
        if now - self._last > 2 * self._period:
            self._last = now

    def _record_pass(self, node: State) -> None:
        node.world.waiting = -1
        ticks = node.world.recording.log
        if ticks is not None:
            if not self._source:
                self._source = node.world.source("Rate")
                ticks.periods.setdefault(self._source, self._period)
                ticks.rates.add(self)
                self._node = node
            expected = self._start + self._passes * self._period
            self._passes += 1
            duration = node.in_run() - self._pass_start
            ticks.add(self._source, self._passes, expected, self._pass_start, duration)
            if watcher := node.world.recording.watcher:
                watcher.says(f"ends pass {self._passes} of its loop.")
            loop = sys._getframe(2)
            self._slept = threading.get_ident(), loop.f_code, loop.f_lasti

    def _moved(self) -> None:
        """Note that the passes are no longer due on the grid of the first ones."""
        log = state().world.recording.log
        if log is not None and self._source:
            log.periods[self._source] = 0

    def _rosspin_coming(self, trails: Mapping[int, Trail]) -> list[tuple[str, int, int, int]]:
        """The next passes: see ``world.graph.Looping``."""
        node = self._node
        thread, code, call = self._slept
        is_asleep = asleep_in_loop(trails.get(thread, []), code, call)
        if is_asleep is None or node.ros_time is not None or self._period <= 0:
            return []
        reals = _next_calls(self._last, node.clock.system(), self._period)
        begins = [*([] if is_asleep else [self._pass_start]), *(real - node.clock.ahead for real in reals)]
        first = self._start + self._passes * self._period
        return [(self._source, self._passes + n + 1, first + n * self._period, real) for n, real in enumerate(begins)]


def _next_calls(mark: int, now: int, period: int) -> list[int]:
    """When ``sleep`` would return, called again and again from ``now`` on, until it has made up for what is overdue."""
    calls = list[int]()
    while not calls or mark <= now:
        if calls and now - mark > 2 * period:
            mark = now
        mark += period
        calls.append(max(mark, now))
    return calls


def sleep(duration: float | genpy.Duration) -> None:
    """Sleep for ``duration`` (seconds or a Duration); return immediately if it is negative.

    A shutdown does not cut short a sleep on the node's own clock. A sleep on ROS time, as told by /clock, drops
    fractions of a nanosecond, and raises ROSInterruptException at shutdown, ROSTimeMovedBackwardsException when the
    time moves backwards, and TypeError if a negative duration reaches back before time 0.
    """
    node = state()
    if isinstance(duration, genpy.Duration):
        _sleep(node, duration.to_nsec())
    elif node.ros_time is None:
        node.clock.sleep(-1 if duration < 0 else nanoseconds(duration))
    else:
        _sleep(node, genpy.Duration.from_sec(duration).to_nsec())


def _sleep(node: State, ns: int) -> None:
    if node.ros_time is None:
        node.clock.sleep(ns)
        return
    while node.ros_time == 0 and not node.shutdown:  # no time has been told yet
        node.wait_for_ros_time(0.3)
    began = node.now()
    if began + ns < 0:
        raise TypeError("time values must be positive")  # as a Time before 0 does
    while began <= node.now() < began + ns and not node.shutdown:
        node.wait_for_ros_time(0.5)
    if (now := node.now()) < began:
        raise ROSTimeMovedBackwardsException((began - now) / 1e9)
    if node.shutdown:
        raise ROSInterruptException("ROS shutdown request")


class _Attributes:
    """Holds a TimerEvent's attributes, as the TimerEvent makes its ``__dict__`` a property."""


class TimerEvent(_Attributes):
    """What a timer passes to its callback. All but ``last_duration`` are Times. In the first call, ``last_*`` are None.

    ``last_expected``, ``last_real``: when the previous call was expected and when it came; ``current_expected``,
    ``current_real``: the same for this call; ``last_duration``: how long the previous call took, in seconds.
    """

    def __init__(
        self,
        last_expected: Time | None,
        last_real: Time | None,
        current_expected: Time,
        current_real: Time,
        last_duration: float | None,
    ) -> None:
        self.last_expected = last_expected
        self.last_real = last_real
        self.current_expected = current_expected
        self.current_real = current_real
        self.last_duration = last_duration

    @property
    def __dict__(self) -> dict[str, Any]:  # type: ignore[override]
        attributes: dict[str, Any] = super().__dict__
        if "_in_ns" in attributes:
            *times, duration = attributes.pop("_in_ns")
            made: list[Any] = [None if time is None else Time._of(time) for time in times]
            made.append(None if duration is None else duration / 1e9)
            made_and_set = vars(TimerEvent(*made)) | attributes
            attributes.clear()
            attributes.update(made_and_set)
        return attributes

    def __getattr__(self, name: str) -> Any:
        try:
            return vars(self)[name]
        except KeyError:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}") from None

    def __getstate__(self) -> dict[str, Any]:
        return vars(self)


def _event(*in_ns: int | None) -> TimerEvent:
    """Make an event from times in ns. Its attributes are made when one is asked for: most callbacks ask for none."""
    event = object.__new__(TimerEvent)
    event._in_ns = in_ns  # type: ignore[attr-defined]
    return event


class Timer(threading.Thread):
    """Calls ``callback(TimerEvent)`` every ``period``, for the first time after one period, in a thread of its own.

    The thread is a daemon; it starts now, and runs even if you keep no reference to the timer. It sleeps on a Rate
    and treats overruns as that does, but never adjusts ``current_expected`` after one. With ``oneshot`` there is only
    one call. An exception in the callback is printed and ends this timer alone. So does a wrong period: 0
    (ZeroDivisionError), a Time (TypeError), or anything else that is not a Duration (AttributeError).
    """

    def __init__(
        self, period: genpy.Duration, callback: Callable[[TimerEvent], Any], oneshot: bool = False, reset: bool = False
    ) -> None:
        super().__init__(daemon=True)
        self._period = period
        self._callback = callback
        self._oneshot = oneshot
        self._reset = reset
        self._shutdown = False
        caller = node_frame(sys._getframe())
        self.made = traceback.FrameSummary(
            caller.f_code.co_filename,
            caller.f_lineno,
            f"{caller.f_code.co_name}, which made this timer",
            lookup_line=False,
        )
        state().world.await_spin()
        self.start()

    def shutdown(self) -> None:
        """Stop calling back. A timer that is asleep notices when it wakes up."""
        if not self._shutdown:
            state().world.await_spin(-1)
        self._shutdown = True

    def _rosspin_coming(self) -> list[tuple[str, int, int, int]]:
        """The next calls: see ``world.graph.Ticking``."""
        is_over = self._shutdown or not self.is_alive() or (self._oneshot and self._number)
        if is_over or self._node.ros_time is not None:
            return []
        clock, period = self._node.clock, self._period.to_nsec()
        reals = _next_calls(self._rate._last, clock.system(), self._rate._period)
        return [
            (self._rosspin_source, number + 1, self._first + number * period - clock.ahead, real - clock.ahead)
            for number, real in enumerate(reals, self._number)
        ]

    def run(self) -> None:
        """Sleep and call back until shutdown, in the timer's thread."""
        node = state()
        clock = node.clock
        rate = Rate(1.0 / self._period.to_sec(), self._reset)
        if not isinstance(self._period, genpy.Duration):
            raise TypeError(f"unsupported operand type(s) for +: 'Time' and '{type(self._period).__name__}'")
        period = self._period.to_nsec()
        expected = node.now() + period
        world = node.world
        ticks = world.recording.log
        source = world.source(getattr(self._callback, "__name__", type(self._callback).__name__))
        if ticks is not None:
            self._rosspin_source = source  # the name under which its ticks are recorded
            node.timers.append(self)
            self._number, self._first, self._rate, self._node = 0, expected, rate, node  # for ``coming``
            ticks.timers.add(self)
            ticks.periods.setdefault(source, period)
        faults = world.graph.faults
        slow = faults.call if faults and faults.slows else None
        watcher = world.recording.watcher
        number = 0
        last_expected = last_real = duration = None  # in ns, like all times here
        while not node.shutdown and not self._shutdown:
            try:
                rate.wait(node)
            except ROSInterruptException:
                if node.shutdown:
                    break
                raise
            if self._shutdown or world.interrupted:
                break
            began, set_to = clock.now(), clock.ahead
            real = in_run = began if node.ros_time is None else node.now()
            due = expected
            if set_to and node.ros_time is None:
                real, due = real + set_to, due - set_to
            number += 1
            world.waiting = -1
            if ticks is not None:
                tick = ticks.add(source, number, due, in_run)
                self._number = number
            callback = self._callback  # calling a local variable skips the search among the methods
            if slow:
                slow(node.name, callback)
            if watcher:
                watcher.calls(callback, late=real - expected)
            try:
                callback(_event(last_expected, last_real, expected, real, duration))
            finally:
                if watcher:
                    watcher.ends(callback)
            duration = clock.now() - began
            if ticks is not None:
                ticks.end(tick, duration)
            duration += clock.ahead - set_to  # rospy asks the system's clock
            if self._oneshot:
                break
            last_expected, last_real = expected, real
            expected += period
