"""Rate, Timer and sleep (source: rospy/timer.py)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..clock import nanoseconds
from . import genpy
from .exceptions import ROSInterruptException, ROSTimeMovedBackwardsException
from .rostime import Duration, Time
from .threads import start_thread
from .world import World, world

__all__ = ["Rate", "Timer", "TimerEvent", "sleep"]


class Rate:
    """Sleeps in a loop so that its passes start ``hz`` times a second.

    Raises ROSInitException before ``init_node``, ZeroDivisionError for 0, TypeError for what is no number. A negative
    rate never sleeps. With ``reset``, ROS time that goes back starts the rate anew instead of raising.
    """

    def __init__(self, hz: float, reset: bool = False) -> None:
        self._last = world().now()
        self._period = int(1e9 / hz)
        self._reset = reset
        self._source = ""
        self._passes = 0
        self._start = self._pass_start = self._last

    @property
    def sleep_dur(self) -> Duration:
        """The period."""
        return Duration._of(self._period)

    @property
    def last_time(self) -> Time:
        """When the current period began."""
        return Time._of(self._last)

    def remaining(self) -> genpy.Duration:
        """How long ``sleep`` would sleep now; negative after an overrun."""
        return Duration._of(self._remaining(world().now()))

    def _remaining(self, now: int) -> int:
        if self._last > now:  # the clock went back
            self._last = now
        return self._period - (now - self._last)

    def sleep(self) -> None:
        """Sleep until the next period begins; return at once if it has begun already.

        A pass of up to 3 periods is made up for by such immediate returns; after a longer one the periods are counted
        from its end, and those missed are lost. Raises ROSTimeMovedBackwardsException and ROSInterruptException as
        :func:`sleep` does.
        """
        here = world()
        self._record_pass(here)
        self.wait(here)
        self._pass_start = here.now()

    def wait(self, here: World) -> None:
        """What ``sleep`` does, for a loop whose passes are not ticks of their own."""
        now = here.now()
        try:
            _sleep(here, self._remaining(now))
        except ROSTimeMovedBackwardsException:
            if not self._reset:
                raise
            self._last = here.now()
            return
        self._last += self._period
        if now - self._last > 2 * self._period:
            self._last = now

    def _record_pass(self, here: World) -> None:
        if here.ticks is not None:
            self._source = self._source or here.source("Rate")
            expected = self._start + self._passes * self._period
            self._passes += 1
            duration = here.now() - self._pass_start
            here.ticks.append([self._source, self._passes, expected, self._pass_start, duration])


def sleep(duration: float | genpy.Duration) -> None:
    """Sleep for ``duration`` (seconds or a Duration); a negative one returns at once.

    On its own clock the node sleeps it out, also during shutdown. On a ROS time that it is told: raises
    ROSInterruptException at shutdown and ROSTimeMovedBackwardsException when the time goes back.
    """
    if isinstance(duration, genpy.Duration):
        _sleep(world(), duration.to_nsec())
    else:
        _sleep(world(), -1 if duration < 0 else nanoseconds(duration))


def _sleep(here: World, ns: int) -> None:
    if here.ros_time is None:
        here.clock.sleep(ns)
        return
    while here.ros_time == 0 and not here.shutdown:  # no time has been told yet
        here.ros_time_changed.wait(300_000_000)
    began = here.now()
    while began <= here.now() < began + ns and not here.shutdown:
        here.ros_time_changed.wait(500_000_000)
    if (now := here.now()) < began:
        raise ROSTimeMovedBackwardsException((began - now) / 1e9)
    if here.shutdown:
        raise ROSInterruptException("ROS shutdown request")


class TimerEvent:
    """What a timer tells its callback. All but ``last_duration`` are Times; what is called last is None at first.

    ``last_expected``, ``last_real``: when the previous callback should have been called and when it was;
    ``current_expected``, ``current_real``: the same for this call; ``last_duration``: how long the previous callback
    took, in seconds.
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


class Timer:
    """Calls ``callback(TimerEvent)`` every ``period``, first after one period, in a thread of its own.

    The thread starts at once and needs no reference to be kept. It paces itself by a Rate, so that what is said there
    of overruns holds here; ``current_expected`` is never adjusted to an overrun. With ``oneshot`` there is one call. An
    exception in the callback is printed and ends this timer alone; so do a period of 0 (ZeroDivisionError) and one that
    is no Duration (AttributeError).
    """

    def __init__(
        self, period: genpy.Duration, callback: Callable[[TimerEvent], Any], oneshot: bool = False, reset: bool = False
    ) -> None:
        self._period = period
        self._callback = callback
        self._oneshot = oneshot
        self._reset = reset
        self._shutdown = False
        self._thread = start_thread(self.run)

    @property
    def name(self) -> str:
        """The name of the timer's thread."""
        return self._thread.name

    def is_alive(self) -> bool:
        """Whether the timer's thread has not ended."""
        return self._thread.alive

    def join(self, timeout: float | None = None) -> None:
        """Wait until the timer's thread has ended, at most ``timeout`` seconds."""
        self._thread.join(timeout)

    def shutdown(self) -> None:
        """Stop calling back; a timer that sleeps sees it when it wakes up."""
        self._shutdown = True

    def run(self) -> None:
        """What the timer's thread does."""
        here = world()
        clock = here.clock
        rate = Rate(1.0 / self._period.to_sec(), self._reset)
        period = self._period.to_nsec()
        expected = here.now() + period
        last_expected: Time | None = None
        last_real: Time | None = None
        last_duration: float | None = None
        ticks = here.ticks
        source = here.source(getattr(self._callback, "__name__", type(self._callback).__name__))
        number = 0
        while not here.shutdown and not self._shutdown:
            try:
                rate.wait(here)
            except ROSInterruptException:
                if here.shutdown:
                    break
                raise
            if self._shutdown or here.over:
                break
            real = here.now()
            began = clock.now()
            current_expected, current_real = Time._of(expected), Time._of(real)
            number += 1
            if ticks is not None:
                tick = [source, number, expected, real, None]
                ticks.append(tick)
            self._callback(TimerEvent(last_expected, last_real, current_expected, current_real, last_duration))
            duration = clock.now() - began
            if ticks is not None:
                tick[4] = duration
            if self._oneshot:
                break
            last_duration = duration / 1e9
            last_expected, last_real = current_expected, current_real
            expected += period
