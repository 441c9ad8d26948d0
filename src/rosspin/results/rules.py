"""The C++ nodes whose ticks are calculated by a rule, because they cannot be run here."""

from __future__ import annotations

from collections.abc import Sequence

from . import rclcpp, roscpp
from .ticks import Tick

__all__ = ["calculated"]


# By the ends of their paths, which no two share.
_RULES = {
    "timing_probes/src/timer_probe.cpp": roscpp.timer_probe,
    "ros2/timer_probe.cpp": rclcpp.timer_probe,
    "ros2/rate_probe.cpp": rclcpp.rate_probe,
}


def calculated(path: str, seconds: float, args: Sequence[str]) -> list[Tick]:
    """Return the ticks of the node in a C++ file with this command line, up to ``seconds``.

    Raises ValueError for any node but the timing probes, and for parameters that the rules do not know.
    """
    for end, rule in _RULES.items():
        if path.endswith(end):
            return rule(seconds, args)
    raise ValueError("C++ cannot be run here: the only rules that are known are those of the timing probes")
