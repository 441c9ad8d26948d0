"""A timer as a run sees it, whichever ROS it is of."""

from __future__ import annotations

from typing import Any, NamedTuple

__all__ = ["Watched"]


class Watched(NamedTuple):
    """A timer: its source, whether it ``has_ended`` and ``was_asked`` to, its period (s), and in ROS 2 its node."""

    timer: Any
    source: str
    has_ended: bool
    was_asked: bool
    period: float
    node: str = ""
