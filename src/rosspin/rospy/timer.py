"""Rate, Timer and sleep (source: rospy/timer.py)."""

from __future__ import annotations

import sys
import threading
import traceback
from collections.abc import Callable
from typing import Any

from ..clocks.clock import nanoseconds
from ..frames import node_frame
from ..messages import genpy
from .exceptions import ROSInterruptException, ROSTimeMovedBackwardsException
from .rostime import Duration, Time
from .state import State, state

__all__ = ["Rate", "Timer", "TimerEvent", "sleep"]


class Rate:
    """Sleeps in a loop so that its passes begin ``hz`` times a second.

    Raises ROSInitException before ``init_node``, ZeroDivisionError if ``hz`` is 0, and TypeError if it is not a number.
    A negative rate never sleeps. With ``reset``, it starts anew when ROS time moves backwards, instead of raising.
    """

    def __init__(self, hz: float, reset: bool = False) -> None:
        self._last = state().now()
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
        return Duration._of(self._remaining(state().now()))

    def _remaining(self, now: int) -> int:
        if self._last > now:  # the clock went back
            self._last = now
        return self._period - (now - self._last)

    def sleep(self) -> None:
        """Sleep until the next period begins; return at once if it has begun already.

        If it is called at most 3 periods after its pass was due to begin, such immediate returns make up for the
        periods that were missed. If it is called later, they are lost, and the next period is counted from this call.
        Raises ROSTimeMovedBackwardsException and ROSInterruptException as :func:`sleep` does.
        """
        node = state()
        self._record_pass(node)
        self.wait(node)
        self._pass_start = node.now()

    def wait(self, node: State) -> None:
        """What ``sleep`` does, for a loop whose passes are not ticks of their own."""
        if node.ros_time is None:
            now = node.clock.now()
            node.clock.sleep(self._remaining(now))
        else:
            now = node.now()
            try:
                _sleep(node, self._remaining(now))
            except ROSTimeMovedBackwardsException:
                if not self._reset:
                    raise
                self._last = node.now()
                return
        self._last += self._period
        if now - self._last > 2 * self._period:
            self._last = now

    def _record_pass(self, node: State) -> None:
        ticks = node.world.graph.ticks
        if ticks is not None:
            self._source = self._source or node.world.source("Rate")
            expected = self._start + self._passes * self._period
            self._passes += 1
            duration = node.now() - self._pass_start
            ticks.append([self._source, self._passes, expected, self._pass_start, duration])


def sleep(duration: float | genpy.Duration) -> None:
    """Sleep for ``duration`` (seconds or a Duration); return at once if it is negative.

    On the node's own clock the sleep is not cut short by a shutdown. On ROS time, as told by /clock, raises
    ROSInterruptException at shutdown and ROSTimeMovedBackwardsException when the time moves backwards.
    """
    if isinstance(duration, genpy.Duration):
        _sleep(state(), duration.to_nsec())
    else:
        _sleep(state(), -1 if duration < 0 else nanoseconds(duration))


def _sleep(node: State, ns: int) -> None:
    if node.ros_time is None:
        node.clock.sleep(ns)
        return
    while node.ros_time == 0 and not node.shutdown:  # no time has been told yet
        node.wait_for_ros_time(0.3)
    began = node.now()
    while began <= node.now() < began + ns and not node.shutdown:
        node.wait_for_ros_time(0.5)
    if (now := node.now()) < began:
        raise ROSTimeMovedBackwardsException((began - now) / 1e9)
    if node.shutdown:
        raise ROSInterruptException("ROS shutdown request")


class TimerEvent:
    """What a timer passes to its callback. All but ``last_duration`` are Times; in the first call, each last is None.

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


class Timer(threading.Thread):
    """Calls ``callback(TimerEvent)`` every ``period``, for the first time after one period, in a thread of its own.

    The thread is a daemon; it starts at once and runs even if you keep no reference to the timer. It sleeps on a Rate,
    so what is said there about overruns holds here, too; ``current_expected`` is never adjusted after an overrun. With
    ``oneshot`` there is only one call. An exception in the callback is printed and ends this timer alone; so does a
    period that is 0 (ZeroDivisionError) or not a Duration (AttributeError).
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
        self.start()

    def shutdown(self) -> None:
        """Stop calling back. A timer that is asleep notices when it wakes up."""
        self._shutdown = True

    def run(self) -> None:
        """What the timer's thread does."""
        node = state()
        clock = node.clock
        rate = Rate(1.0 / self._period.to_sec(), self._reset)
        period = self._period.to_nsec()
        expected = node.now() + period
        last_expected: Time | None = None
        last_real: Time | None = None
        last_duration: float | None = None
        ticks = node.world.graph.ticks
        source = node.world.source(getattr(self._callback, "__name__", type(self._callback).__name__))
        if ticks is not None:
            self.source = source  # under which its ticks are recorded
            node.timers.append(self)
        number = 0
        while not node.shutdown and not self._shutdown:
            try:
                rate.wait(node)
            except ROSInterruptException:
                if node.shutdown:
                    break
                raise
            if self._shutdown or node.world.interrupted:
                break
            began = clock.now()
            real = began if node.ros_time is None else node.now()
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
