"""Scenarios on a real clock: on the real ROS 1 and 2, and on the stand-ins. Recordings are stale once this changes."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable, Sequence
from contextlib import ExitStack
from functools import cache
from typing import Self

from rosspin.real import ros1, ros2
from rosspin.real.children import Children

from .corpus import Scenario
from .outcomes import JITTER
from .tree import ROOT

KILTED_PYTHON = ROOT / "build" / "ros2-kilted" / "bin" / "python"

# Where scenarios of ROS 1 and 2 run. The first is the judge, whose outcome is recorded.
RUNTIMES = {1: ("ros1", "wall"), 2: ("ros2", "kilted", "wall")}

_ZERO = re.compile(r"@zero (\d+\.\d+)")

# The time that they tell, the parameter that has them believed, and a topic that has another's name in one run and not
# in the next are all nodes' of a master.
_OWN_MASTER = ("topics_clock", "topics_names")


@cache
def version(runtime: str) -> str:
    """Which of its kind is installed here; "" if none is."""
    if runtime == "ros1":
        command = ["dpkg-query", "--show", "--showformat=rospy ${Version}", "python3-rospy"]
        return subprocess.run(command, capture_output=True, text=True).stdout
    return ros2.version() if runtime == "ros2" else ""


class Machine:
    """Runs scenarios in ``runtimes``, any number at a time. Leaving it ends all that was started."""

    def __init__(self, runtimes: Iterable[str]) -> None:
        self._stack = ExitStack()
        self._children: dict[str, Children] = {}
        for runtime in runtimes:
            kind = {"ros1": ros1.Workspace, "wall": Children}.get(runtime, ros2.Nodes)
            self._children[runtime] = self._stack.enter_context(kind())
        if "ros1" in self._children:
            _started(self._children["ros1"])

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self._stack.close()

    def run(self, runtime: str, scenario: Scenario) -> str:
        """The console of a scenario; its status in the first line."""
        with ExitStack() as stack:
            children = self._children[runtime]
            if runtime == "ros1" and scenario.file.startswith(_OWN_MASTER):
                children = _started(stack.enter_context(ros1.Workspace()))
            return _run(children, _command(runtime), scenario)


def _started(workspace: Children) -> Children:
    assert isinstance(workspace, ros1.Workspace)
    workspace.start_master()
    return workspace


def _command(runtime: str) -> list[str]:
    if runtime == "wall":
        return [sys.executable, "-m", "rosspin", "run"]
    return [{"ros1": "python3", "ros2": ros2.python(), "kilted": str(KILTED_PYTHON)}[runtime]]


def _run(children: Children, command: Sequence[str], scenario: Scenario) -> str:
    end = ["--"] if "rosspin" in command else []
    words = [*command, str(scenario.path), *end, *scenario.node_args]
    output = children.run(words, scenario.seconds, begins=_ZERO if scenario.is_timed else None)
    console = output.console
    # The scenario itself says when it has stalled; whether Ctrl-C came in time is known here.
    if (zero := _ZERO.search(console)) and output.interrupt:
        late = output.interrupt - float(zero[1]) - scenario.seconds
        if late > JITTER:
            console = f"@stall {late:.3f}\n{console}"
    return f"status {output.status}\n{console}"


def kept(text: str) -> str:
    """A console without what differs in every run, or on another machine."""
    for pattern, instead in (
        (r"@(zero|stall).*\n", ""),
        (r"\[\d+\.\d{9}\]", "[STAMP]"),
        (r"\[\d{10}\.\d{6}(, \d+\.\d{6})?\]", r"[STAMP\1]"),
        (r"\b0x[0-9a-f]+", "0xN"),
        (r", at \S+:\d+", ""),
        (r'(?m)^  File "(?!.*/scenarios\w*/).*\n(?:    .*\n)*', ""),
        (r'File "/.*/(scenarios\w*)/', r'File "/\1/'),
    ):
        text = re.sub(pattern, instead, text)
    return text
