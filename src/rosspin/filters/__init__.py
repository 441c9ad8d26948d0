"""What both ROSes' message_filters do with messages and their stamps (source: message_filters/__init__.py of each).

Each ROS adds what its times, its clock and its log are.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

__all__ = ["ApproximateTimeSynchronizer", "Cache", "Queue", "SimpleFilter", "TimeSynchronizer"]

Queue = dict[int, Any]  # messages by their stamps in ns


class SimpleFilter:
    """Something that messages come out of."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Have ``cb`` called with what comes out, and with ``args`` after that. Return its number."""
        number = len(self.callbacks)
        self.callbacks[number] = (cb, args)
        return number

    def signalMessage(self, *msg: Any) -> None:
        """Give messages to the callbacks."""
        for callback, args in self.callbacks.values():
            callback(*msg, *args)


class _Stamped(SimpleFilter):
    """Goes by the stamps of messages; with ``allow_headerless``, by when they come if they have none."""

    allow_headerless: bool

    def _time_of(self, message: Any) -> Any:
        """Return the time of a message; None if it has none and must have one."""
        if hasattr(message, "header") and hasattr(message.header, "stamp"):
            return self._time(message.header.stamp)
        if self.allow_headerless:
            return self._now()
        self._warn()
        return None

    def _time(self, stamp: Any) -> Any:
        """Return a stamp as a time of this ROS."""
        raise NotImplementedError

    def _now(self) -> Any:
        """Return the current time."""
        raise NotImplementedError

    def _warn(self) -> None:
        """Log that a message without a stamp was not taken."""
        raise NotImplementedError


class Cache(_Stamped):
    """Keeps the newest ``cache_size`` messages of the filter ``f``, in the order in which they came."""

    def __init__(self, f: Any, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.connectInput(f)
        self.cache_size = cache_size
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Any] = []
        self.allow_headerless = allow_headerless

    def connectInput(self, f: Any) -> None:
        """Take messages from this filter, too."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep a message, and pass it on."""
        time = self._time_of(msg)
        if time is None:
            return
        self.cache_times.append(time)
        self.cache_msgs.append(msg)
        if len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Any, to_stamp: Any) -> list[Any]:
        """The messages from one time to another. Raises AssertionError if the second is earlier."""
        assert from_stamp <= to_stamp
        return self._where(lambda time: from_stamp <= time <= to_stamp)

    def getElemAfterTime(self, stamp: Any) -> Any:
        """The first message that is not before this time; None if there is none."""
        return next(iter(self._where(lambda time: time >= stamp)), None)

    def getElemBeforeTime(self, stamp: Any) -> Any:
        """The last message that is not after this time; None if there is none."""
        return next(reversed(self._where(lambda time: time <= stamp)), None)

    def getLastestTime(self) -> Any:  # the name that both have
        """The time of the message that came last; None if there is none."""
        return self.cache_times[-1] if self.cache_times else None

    def getOldestTime(self) -> Any:
        """The time of the message that has been here for longest; None if there is none."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """The first message that is not before the one that came last; None if there is none."""
        return self.getElemAfterTime(self.getLastestTime()) if self.cache_times else None

    def _where(self, fits: Callable[[Any], bool]) -> list[Any]:
        return [message for message, time in zip(self.cache_msgs, self.cache_times, strict=True) if fits(time)]


class TimeSynchronizer(SimpleFilter):
    """Passes on messages of the filters ``fs``, one of each, that have the same stamp.

    Of each filter at most ``queue_size`` messages wait, the newest by their stamps.
    """

    def __init__(self, fs: Sequence[Any], queue_size: int) -> None:
        super().__init__()
        self.connectInput(fs)
        self.queue_size = queue_size
        self.lock = threading.Lock()

    def connectInput(self, fs: Sequence[Any]) -> None:
        """Take messages from these filters."""
        self.queues: list[Queue] = [{} for _ in fs]
        self.input_connections = [
            each.registerCallback(self.add, queue, number)
            for number, (each, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Take a message for one of the queues, and pass on what is complete."""
        self.lock.acquire()  # as in the real one, a callback that raises leaves it locked
        if self._take(msg, self._nanoseconds(msg.header.stamp), my_queue, my_queue_index):
            for stamp in sorted(set.intersection(*map(set, self.queues))):
                self._pass_on([stamp] * len(self.queues))
        self.lock.release()

    def _pass_on(self, stamps: Sequence[int]) -> None:
        found = list(zip(self.queues, stamps, strict=True))
        self.signalMessage(*(queue[stamp] for queue, stamp in found))
        for queue, stamp in found:
            del queue[stamp]

    def _take(self, message: Any, stamp: int, queue: Queue, number: int | None) -> bool:
        """Put a message into a queue. Return whether to look now for what is complete."""
        queue[stamp] = message
        self._trim(queue)
        return True

    def _trim(self, queue: Queue) -> None:
        while len(queue) > self.queue_size:
            del queue[min(queue)]

    def _nanoseconds(self, stamp: Any) -> int:
        """Return a stamp, or a time of this ROS, in ns."""
        raise NotImplementedError


class ApproximateTimeSynchronizer(TimeSynchronizer, _Stamped):
    """Passes on messages, one of each filter, whose stamps are less than ``slop`` (ns) apart."""

    _slop: int

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Take a message for one of the queues, and pass it on with those that fit, if there are any."""
        time = self._time_of(msg)
        if time is None:
            return
        stamp = self._nanoseconds(time)
        self.lock.acquire()
        if self._take(msg, stamp, my_queue, my_queue_index) and (match := self._match(stamp, my_queue_index)):
            self._pass_on(match)
        self.lock.release()

    def _match(self, stamp: int, number: int | None) -> list[int]:
        """Return the stamps, one of each queue, that go with one in the queue of this number; none if one lacks."""
        others = [queue for each, queue in enumerate(self.queues) if each != number]
        nearest = [
            sorted((each for each in queue if abs(each - stamp) <= self._slop), key=lambda each: abs(each - stamp))
            for queue in others
        ]
        for each in product(*nearest):
            stamps = list(each)
            if number is not None:
                stamps.insert(number, stamp)
            waits = all(each in queue for queue, each in zip(self.queues, stamps, strict=True))
            if max(stamps) - min(stamps) < self._slop and waits:
                return stamps
        return []
