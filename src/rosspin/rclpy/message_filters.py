"""message_filters for nodes of ROS 2 (source: message_filters/__init__.py 4.11.2). Loaded when a node imports it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from types import ModuleType
from typing import Any

from .. import filters
from ..filters import SimpleFilter
from .clock import ROSClock
from .duration import Duration
from .logging import LoggingSeverity, get_logger
from .time import Time

__all__ = ["ApproximateTimeSynchronizer", "Cache", "SimpleFilter", "Subscriber", "TimeSynchronizer"]


class Subscriber(SimpleFilter):
    """The messages of a topic. It takes a node and what ``create_subscription`` takes, but for the callback.

    Without ``qos_profile`` its depth is 10. It has what a subscription has.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.node = args[0]
        self.topic = args[2]
        kwargs.setdefault("qos_profile", 10)
        self.sub = self.node.create_subscription(*args[1:], self.callback, **kwargs)

    def callback(self, msg: Any) -> None:
        """Take a message of the topic."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """The topic, as it was given."""
        return str(self.topic)

    def __getattr__(self, key: str) -> Any:
        return getattr(self.sub, key)


class _Stamps:
    """What stamps, the clock and the log are in ROS 2."""

    _LOGGER: str
    _LACKING: str

    def _time(self, stamp: Any) -> Time:
        return stamp if hasattr(stamp, "nanoseconds") else Time.from_msg(stamp)

    def _now(self) -> Time:
        return ROSClock().now()

    def _nanoseconds(self, stamp: Any) -> int:
        return self._time(stamp).nanoseconds

    def _warn(self) -> None:
        logger = get_logger(self._LOGGER)
        logger.set_level(LoggingSeverity.INFO)
        logger.warning(
            f"can not use message filters {self._LACKING} without timestamp infomation when 'allow_headerless' is "
            "disabled. auto assign ROSTIME to headerless messages once enabling constructor option of "
            "'allow_headerless'."
        )


class Cache(_Stamps, filters.Cache):
    __doc__ = filters.Cache.__doc__
    _LOGGER, _LACKING = "message_filters_cache", "messages"


class TimeSynchronizer(_Stamps, filters.TimeSynchronizer):
    __doc__ = filters.TimeSynchronizer.__doc__


class ApproximateTimeSynchronizer(filters.ApproximateTimeSynchronizer, TimeSynchronizer):
    """Passes on messages, one of each filter, whose stamps are less than ``slop`` (s) apart."""

    _LOGGER, _LACKING = "message_filters_approx", "for messages"

    def __init__(self, fs: Sequence[Any], queue_size: int, slop: float, allow_headerless: bool = False) -> None:
        TimeSynchronizer.__init__(self, fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless

    @property
    def _slop(self) -> int:  # type: ignore[override]
        return self.slop.nanoseconds


# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {"message_filters": sys.modules[__name__]}
