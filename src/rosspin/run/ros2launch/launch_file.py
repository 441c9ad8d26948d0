"""Which launch file of ROS 2 should run, and how."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

__all__ = ["LaunchFile"]


class LaunchFile(NamedTuple):
    """A launch file with its arguments, as in ``"rate:=10"``, and whether its nodes in C++ are left out."""

    path: str
    args: Sequence[str] = ()
    skip_cpp: bool = False
