"""What the corpora of scenarios have in common: what a scenario is, and what it gives, simulated and as recorded.

What the real ROS gave is kept with the scenarios, in ``recorded/``: the console of each with its status in the first
line, stamps made equal. Where the real one's outcome is a race, there may be several: ``NAME~2.txt``.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple
from unittest import mock

from rosspin import simulate

from .outcomes import CTRL_C, Outcome, differences, outcome

LONGEST = 12.0  # s of a scenario that ends by itself

# Longer names are numbered instead.
_LONGEST_NAME = 40

Args = tuple[str, ...]


class Scenario(NamedTuple):
    """A scenario for ROS 1 or 2: its file and node args, and a name for both."""

    ros: int
    path: Path
    args: Args
    name: str

    @property
    def file(self) -> str:
        return self.path.stem

    @property
    def node_args(self) -> Args:
        """The args of a run. Nodes of one ROS 1 master need names of their own; those that print theirs have one."""
        own = self.ros == 1 and not self.file.startswith("values")
        return (*self.args, f"__name:={self.name}") if own else self.args

    @property
    def is_timed(self) -> bool:
        """Whether it is about times."""
        return re.search(r"^ *begin\(", self.path.read_text(), re.M) is not None

    @property
    def end(self) -> float | None:
        """When Ctrl-C comes, in those that are about it or would not end without it."""
        return CTRL_C if self.file.startswith(("ctrl_c", "deadlock")) else None

    @property
    def seconds(self) -> float:
        """When Ctrl-C comes, if it has not ended by then."""
        return self.end or LONGEST

    @property
    def recordings(self) -> list[Path]:
        """Where it is kept what the real one gave: one outcome, several if it is a race."""
        files = sorted((self.path.parent / "recorded").glob(f"{self.name}*.txt"))
        return [file for file in files if file.stem.split("~")[0] == self.name]


def scenarios(ros: int, folder: Path, args: Mapping[str, Sequence[Args]]) -> list[Scenario]:
    """The scenarios in a folder; ``args`` has the arguments of the files that have any."""
    return [
        Scenario(ros, file, each, _name(file.stem, each, number))
        for file in sorted(folder.glob("*.py"))
        if file.stem != "scenario"
        for number, each in enumerate(args.get(file.stem, [()]), 1)
    ]


def _name(file: str, args: Args, number: int) -> str:
    name = re.sub(r"\W+", "_", "_".join((file, *args)))
    return name if len(name) <= _LONGEST_NAME else f"{file}_{number}"


def given(name: str, values: Iterable[float], *more: str) -> list[Args]:
    """Args that give a name each of these values, and the rest as it is."""
    return [(f"{name}:={value}", *more) for value in values]


@cache
def simulated(scenario: Scenario, jitter: float = 0.0) -> Outcome:
    """What a scenario gives in simulated time; with ``jitter`` (s) each of its blocks takes so much longer."""
    late = {1: "_jitter", 2: "jitter"}[scenario.ros]
    more = [f"{late}:={jitter}"] if jitter else []
    with mock.patch.dict(os.environ):  # a node may set the form of its log lines there
        run = simulate(scenario.path, scenario.seconds, [*scenario.node_args, *more])
    return outcome(run.console, run.status, scenario.end)


def read(text: str, scenario: Scenario) -> Outcome:
    """The outcome that a text with the status in its first line tells of."""
    status, _, console = text.partition("\n")
    return outcome(console, int(status.removeprefix("status ")), scenario.end)


def recorded(scenario: Scenario) -> list[Outcome]:
    """What the real one gave."""
    return [read(file.read_text(), scenario) for file in scenario.recordings]


def closest(exact: Sequence[Outcome], other: Outcome) -> list[str]:
    """How an outcome differs from that one of several which is most like it."""
    return min((differences(one, other) for one in exact), key=len, default=["nothing is recorded"])
