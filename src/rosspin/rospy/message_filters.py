"""message_filters for nodes of ROS 1 (source: message_filters/__init__.py 1.15.15). Loaded when a node imports it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from types import ModuleType
from typing import Any

from .. import filters
from ..filters import SimpleFilter
from .core import logdebug, loginfo, logwarn
from .rostime import Duration, Time, is_wallclock
from .topics import Subscriber as TopicSubscriber

__all__ = ["ApproximateTimeSynchronizer", "Cache", "SimpleFilter", "Subscriber", "TimeSynchronizer"]


class Subscriber(SimpleFilter):
    """The messages of a topic. It takes what rospy.Subscriber takes, but for the callback, and has what that has."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.topic = args[0]
        kwargs["callback"] = self.callback
        self.sub = TopicSubscriber(*args, **kwargs)

    def callback(self, msg: Any) -> None:
        """Take a message of the topic."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """The topic, as it was given."""
        return str(self.topic)

    def __getattr__(self, key: str) -> Any:
        return getattr(self.sub, key)


class _Stamps:
    """What stamps, the clock and the log are in ROS 1."""

    def _time(self, stamp: Any) -> Any:
        return stamp

    def _now(self) -> Time:
        return Time.now()

    def _warn(self) -> None:
        logwarn(
            "Cannot use message filters with non-stamped messages. Use the 'allow_headerless' constructor option to "
            "auto-assign ROS time to headerless messages."
        )


class Cache(_Stamps, filters.Cache):
    __doc__ = filters.Cache.__doc__

    def getLatestTime(self) -> Any:
        """The time of the message that came last; None if there is none."""
        return self.getLastestTime()


class TimeSynchronizer(filters.TimeSynchronizer):
    """Passes on messages of the filters ``fs``, one of each, that have the same stamp.

    Of each filter at most ``queue_size`` messages wait, the newest by their stamps. With ``reset``, simulated time that
    jumps back empties the queues.
    """

    def __init__(self, fs: Sequence[Any], queue_size: int, reset: bool = False) -> None:
        super().__init__(fs, queue_size)
        self.enable_reset = reset

    def connectInput(self, fs: Sequence[Any]) -> None:
        """Take messages from these filters."""
        super().connectInput(fs)
        self.latest_stamps = [Time(0) for _ in fs]

    def _nanoseconds(self, stamp: Any) -> int:
        return int(stamp.to_nsec())

    def _take(self, message: Any, stamp: int, queue: filters.Queue, number: int | None) -> bool:
        now = Time.now()
        resets = self.enable_reset and not is_wallclock()
        if resets and number is not None:
            if now < self.latest_stamps[number]:
                logdebug("Detected jump back in time. Clearing message filter queue")
                queue.clear()
            self.latest_stamps[number] = now
        queue[stamp] = message
        self._look_at(now)
        self._trim(queue)
        return not resets or max(self.latest_stamps) == now

    def _look_at(self, now: Time) -> None:
        """Notice the time at which a message came."""


class ApproximateTimeSynchronizer(_Stamps, filters.ApproximateTimeSynchronizer, TimeSynchronizer):
    """Passes on messages, one of each filter, whose stamps are less than ``slop`` (s) apart.

    Time that jumps back empties the queues.
    """

    def __init__(
        self, fs: Sequence[Any], queue_size: int, slop: float, allow_headerless: bool = False, reset: bool = False
    ) -> None:
        TimeSynchronizer.__init__(self, fs, queue_size, reset)
        self.slop = Duration.from_sec(slop)
        self.allow_headerless = allow_headerless
        self.last_added = Time()

    @property
    def _slop(self) -> int:  # type: ignore[override]
        return self.slop.to_nsec()

    def _look_at(self, now: Time) -> None:
        if now < self.last_added:
            loginfo("ApproximateTimeSynchronizer: Detected jump back in time. Clearing buffer.")
            for queue in self.queues:
                queue.clear()
        self.last_added = now


# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {"message_filters": sys.modules[__name__]}
