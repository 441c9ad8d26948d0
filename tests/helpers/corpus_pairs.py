"""The scenarios of several processes of ROS 2: what one is, and what each process gives, simulated, real and recorded.

The files of a scenario are its processes, SCENARIO_PROCESS.py. Each process's console on the real ROS is kept in
``recorded/``, with its status in the first line.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from rosspin import Node
from rosspin.clocks.simulation import Simulation
from rosspin.real import ros2
from rosspin.real.children import shell_status
from rosspin.run.roslaunch import launch
from rosspin.run.simulate import run_nodes
from rosspin.run.streams import capture

from .corpus import Args
from .outcomes import Outcome, differences, outcome
from .runtimes import kept
from .tree import TESTS

__all__ = ["LEDGER", "PAIRS", "PAIR_LIST", "Pair", "differing", "read", "recorded", "run", "simulated"]

PAIRS = TESTS / "scenarios_pairs"
LEDGER = PAIRS / "ledger.toml"

LONGEST = 90.0  # s of a scenario that ends by itself, on a real ROS
CTRL_C = 4.0  # s after the first line of those that Ctrl-C ends

_ARGS: dict[str, Args] = {
    "remapped_listener": ("--ros-args", "-r", "words:=other", "-r", "__node:=renamed"),
    "own_parameters_left": ("--ros-args", "-p", "rate:=10.0"),
    "namespaces_talker": ("--ros-args", "-r", "__ns:=/left"),
    "namespaces_listener": ("--ros-args", "-r", "__ns:=/right"),
    "logging_quiet": ("--ros-args", "--log-level", "quiet:=error"),
}

# A line of a process says whose it is; of what rclpy logs the logger does, which is named as the process.
_LINE = re.compile(r"(\w+): (.*\n)")
_LOGGED = re.compile(r"\[\w+\] \[[\d.]+\] \[(?:\w+\.)*(\w+)\]: .*\n")
_FIRST_LINE = re.compile("")


class Pair(NamedTuple):
    """A scenario of several processes, by the names of which it has their files."""

    name: str
    files: Mapping[str, Path]

    ros: int = 2

    @property
    def args(self) -> tuple[Args, ...]:
        """The command line of each."""
        return tuple(_ARGS.get(file.stem, ()) for file in self.sources)

    @property
    def sources(self) -> list[Path]:
        """The files."""
        return list(self.files.values())

    @property
    def seconds(self) -> float:
        """When Ctrl-C comes, if all have not ended by then."""
        return CTRL_C if self.name.startswith("ctrl_c") else LONGEST

    @property
    def recordings(self) -> list[Path]:
        """Where it is kept what each process gave."""
        return [file for file in self._recordings.values() if file.exists()]

    @property
    def _recordings(self) -> dict[str, Path]:
        return {name: PAIRS / "recorded" / f"{file.stem}.txt" for name, file in self.files.items()}

    def record(self, texts: Mapping[str, str]) -> None:
        """Keep what each process gave."""
        for name, file in self._recordings.items():
            file.parent.mkdir(exist_ok=True)
            file.write_text(kept(texts[name]), encoding="utf-8")


def _pairs() -> list[Pair]:
    files = sorted(file for file in PAIRS.glob("*.py") if file.stem != "scenario")
    groups = groupby(files, lambda file: file.stem.rpartition("_")[0])
    return [Pair(name, {file.stem.rpartition("_")[2]: file for file in group}) for name, group in groups]


PAIR_LIST = _pairs()


def simulated(pair: Pair) -> dict[str, Outcome]:
    """What the processes of a scenario give in simulated time."""
    nodes = launch.Launch([Node(file, args) for file, args in zip(pair.sources, pair.args, strict=True)])
    with capture() as console:
        processes = run_nodes(nodes, pair.seconds, Simulation()).host.processes
    texts = dict.fromkeys(pair.files, "")
    for line in console.text().splitlines(keepends=True):
        found = _LINE.match(line) or _LOGGED.match(line)
        if found and found[1] in texts:
            texts[found[1]] += line
    statuses = [shell_status(process.world.exit_status or 0) for process in processes]
    return {
        name: outcome(_unnamed(texts[name]), status, None) for name, status in zip(pair.files, statuses, strict=True)
    }


def run(pair: Pair) -> dict[str, str]:
    """What each process of a scenario gives on the real ROS 2, with its status in the first line."""
    begins = _FIRST_LINE if pair.name.startswith("ctrl_c") else None

    def run_one(file: Path, args: Args) -> str:
        output = nodes.run([ros2.python(), str(file), *args], pair.seconds, begins=begins)
        return f"status {output.status}\n{_unnamed(output.console)}"

    with ros2.Nodes(meet=True) as nodes, ThreadPoolExecutor(len(pair.files)) as pool:
        return dict(zip(pair.files, pool.map(run_one, pair.sources, pair.args), strict=True))


def _unnamed(console: str) -> str:
    return re.sub(f"^{_LINE.pattern}", r"\2", console, flags=re.M)


def read(texts: Mapping[str, str]) -> dict[str, Outcome]:
    """The outcomes that texts with the status in the first line tell of."""
    parts = {process: text.partition("\n") for process, text in texts.items()}
    return {
        process: outcome(console, int(status.removeprefix("status ")), None)
        for process, (status, _, console) in parts.items()
    }


def recorded(pair: Pair) -> dict[str, Outcome]:
    """What the real one gave."""
    return read({name: file.read_text(encoding="utf-8") for name, file in pair._recordings.items() if file.exists()})


def differing(exact: Mapping[str, Outcome], other: Mapping[str, Outcome]) -> list[str]:
    """How the processes' outcomes differ."""
    if exact.keys() != other.keys():
        return [f"recorded are {', '.join(exact) or 'none'}"]
    return [f"{process}: {found}" for process in exact for found in differences(exact[process], other[process])]
