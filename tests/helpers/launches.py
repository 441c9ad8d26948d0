"""Runs on a real ROS that continue until the node has done what a test is about: no test knows how long that takes."""

from __future__ import annotations

import io
import re
import time
from collections.abc import Sequence
from pathlib import Path
from unittest import mock

from rosspin.real import ros2
from rosspin.results.ticks import Run

from .expectations import mishaps
from .verdicts import inconclusive

__all__ = ["NEVER", "Until", "launch", "launch_past", "unspoilt"]

NEVER = 120.0  # s; only so that a run ends that goes wrong


class Until(io.StringIO):
    """A console that is closed, which ends the run, once each of these patterns has come so many ``times``.

    A little later, half-way between two ticks at 2 Hz: a node of the real rospy that Ctrl-C met as it logged did not
    end, and had to be killed.
    """

    def __init__(self, *patterns: str, times: int = 1) -> None:
        super().__init__()
        self._patterns = patterns
        self._times = times

    def write(self, text: str) -> int:
        written = super().write(text)
        missing = [each for each in self._patterns if len(re.findall(each, self.getvalue())) < self._times]
        if self._patterns and not missing:
            self._patterns = ()  # what is said of the run at its end may still be written
            time.sleep(0.25)
            raise BrokenPipeError
        return written


def unspoilt(console: str) -> str:
    """The console of a run on the real ROS 2 that Ctrl-C ended; inconclusive if that met rclpy's own shutdown."""
    if met := mishaps("ros2").search(console):
        inconclusive(f"Ctrl-C met rclpy's own shutdown, see its issue 1352: {met[0].strip()}")
    return console


def launch(node: Path, seconds: float, args: Sequence[str] = (), onward: io.StringIO | None = None) -> Run:
    """Run a node on the real ROS 2 for so long from the moment in which it has been made, unspoilt."""
    run = ros2.launch(node, seconds, args, onward)
    unspoilt(run.console)
    return run


def launch_past(line: str, node: Path, args: Sequence[str] = ()) -> Run:
    """Press Ctrl-C 0.25 s after such a line has come: half-way between two ticks, if they come at 2 Hz."""
    with mock.patch.object(ros2, "_BEGIN", re.compile(line)):
        return launch(node, 0.25, args)
