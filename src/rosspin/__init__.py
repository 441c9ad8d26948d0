"""Run a ROS node that spins at a frequency without ROS, and see when it ticked."""

from __future__ import annotations

from typing import Any

from .rospy.world import NotSimulated
from .run import Run, Tick, TimeStandsStill, measure, simulate

__all__ = ["NotSimulated", "Run", "Tick", "TimeStandsStill", "measure", "simulate"]


def load_ipython_extension(shell: Any) -> None:
    """``%load_ext rosspin``: the cell magics ``%%simulate`` and ``%%measure``."""
    from .magics import Magics

    shell.register_magics(Magics)
