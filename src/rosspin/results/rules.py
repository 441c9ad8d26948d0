"""The C++ nodes whose ticks are calculated by a rule, because they cannot be run here."""

from __future__ import annotations

from collections.abc import Sequence

from . import rclcpp, roscpp
from .ticks import Tick

__all__ = ["calculated"]


def calculated(path: str, seconds: float, args: Sequence[str]) -> list[Tick]:
    """The ticks of the node in a C++ file with this command line, up to ``seconds``.

    Raises ValueError for any node but the timing probes, and for parameters that the rules do not know.
    """
    if path.endswith("timing_probes/src/timer_probe.cpp"):
        return roscpp.timer_probe(seconds, args)
    if path.endswith(("ros2/timer_probe.cpp", "ros2/rate_probe.cpp")):
        return rclcpp.probe(path, seconds, args)
    raise ValueError("C++ cannot be run here: the only rules that are known are those of the timing probes")
