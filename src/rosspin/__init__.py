"""Run a ROS node without ROS, and see when it ticked."""

from __future__ import annotations

from typing import Any

from .run import TimeStandsStill, measure, simulate
from .ticks import Message, Run, Tick
from .world import NotSimulated

__all__ = ["Message", "NotSimulated", "Run", "Tick", "TimeStandsStill", "measure", "simulate"]


def load_ipython_extension(shell: Any) -> None:
    """``%load_ext rosspin``: the cell magics ``%%simulate`` and ``%%measure``."""
    from .site.magics import Magics

    shell.register_magics(Magics)
