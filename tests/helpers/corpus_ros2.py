"""The scenarios for ROS 2: their list, how each runtime runs them, and what the real rclpy gave.

That is kept beside them, in ``recorded/``: the console of each with its status in the first line, stamps made equal.
Where threads meet a shutdown the real one's outcome is a race, and there may be several: ``NAME~2.txt``.

    python tests/helpers/corpus_ros2.py [NAME...]   run on the real rclpy, record, and say what has changed
    python tests/helpers/corpus_ros2.py --simulated [NAME...]
        run in simulated time, and say what differs from what is recorded
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple
from unittest import mock

from outcomes import CTRL_C, MET_SHUTDOWN, TRIES, Outcome, differences, outcome, run_scenario
from tree import ROOT, TESTS

from rosspin import ros2, simulate
from rosspin.children import Children

SCENARIOS = TESTS / "scenarios_ros2"
RECORDED = SCENARIOS / "recorded"
KILTED_PYTHON = ROOT / "build" / "ros2-kilted" / "bin" / "python"

LONGEST = 12.0  # s of a scenario that ends by itself
AT_ONCE = 4


class Scenario(NamedTuple):
    """A scenario file with its node args, and a name for both."""

    file: str
    args: tuple[str, ...]
    name: str

    @property
    def path(self) -> Path:
        return SCENARIOS / f"{self.file}.py"

    @property
    def is_timed(self) -> bool:
        """Whether it is about times."""
        return "begin()" in self.path.read_text()

    @property
    def end(self) -> float | None:
        """When Ctrl-C comes, in those that are about it."""
        return CTRL_C if self.file.startswith("ctrl_c") else None


def _with(name: str, values: Sequence[float], *more: str) -> list[tuple[str, ...]]:
    return [(f"{name}:={value}", *more) for value in values]


def _name(file: str, args: tuple[str, ...], number: int) -> str:
    if len(args) <= 1 and "--" not in "".join(args):
        return re.sub(r"\W+", "_", "_".join((file, *args)))
    return f"{file}_{number}"


_ARGS: dict[str, list[tuple[str, ...]]] = {
    "timer_blocked_once": _with("block", (0.6, 1.4, 1.6, 2.4, 3.6, 4.4)),
    "timer_blocked_always": _with("block", (0.5, 1.6, 2.4)),
    "rate_in_thread": _with("block", (0.6, 1.4, 2.4, 4.4)),
    "topics_depth": _with("depth", (1, 3, 10)),
    "topics_names": [(), ("--ros-args", "-r", "old:=new", "-r", "~/private:=/elsewhere", "-r", "__ns:=/mrp")],
    "values_names": [
        (),
        ("--ros-args", "-r", "__ns:=/mrp", "-r", "chatter:=other"),
        ("plain", "--ros-args", "-r", "__node:=renamed", "-r", "/chatter:=/x/y", "--", "--flag"),
        ("--ros-args", "-r", "values_names:__ns:=/a/b", "-r", "other:__node:=another", "--remap", "a:=b"),
    ],
    "values_parameters": [(), ("word", "--ros-args", "-p", "rate:=10.5", "-p", "text:=from the command line")],
    "parameters_overrides": [
        (
            *("--ros-args", "-p", "rate:=10.0", "-p", "whole:=10", "-p", "dynamic:=word", "-p", "text:='10'"),
            *("-p", "list:=[1, 2, 3]", "-p", "flag:=true", "-p", "typed:=yes", "-p", "untyped:=[1.5, 2.5]"),
            *("-p", "ignored:=9", "-p", "another:other:=7", "-p", "parameters_overrides:other:=8"),
        ),
        ("--ros-args", "--param", "rate:=.5", "-p", "a.b:=1", "-p", "list:=[a, b]", "-p", "text:=1e3x"),
    ],
    "log_on_the_command_line": [
        ("--ros-args", "--log-level", "DEBUG"),
        ("--ros-args", "--log-level", "error"),
        ("--ros-args", "--log-level", "free:=debug", "--log-level", "warn"),
        ("--ros-args", "-r", "__ns:=/mrp", "--log-level", "mrp.node:=debug"),
    ],
}

# Where the real one's outcome is a race, and why. What is simulated is one of those that it had.
RACES: dict[str, str] = {
    "ctrl_c_rate_in_main": "whether the thread that spins sees the context go before the interpreter does",
    **dict.fromkeys(
        ("executor_multi_raises", "executor_raises_later_spin"),
        "whether the callback has ended before its own end makes the executor look again",
    ),
    "topics_wait_while_spun": "whether the one who waits or the executor that spins takes the message",
}

# Where the stand-in is known to do otherwise, and how.
DIFFERENT: dict[str, str] = dict.fromkeys(
    ("ctrl_c_no_handlers", "ctrl_c_own_handler"),
    "a handler that is not rclpy's is called at once; on the real one only when what the executor waits for is due",
)

# Where Kilted does otherwise than Jazzy, the reference, and how. docs/reference/rclpy-names.rst tells of it.
_ENUMS = "the types of clocks are an enum, those of parameters are shown as numbers"
_INIT = "rclpy.init() returns a context manager"
KILTED: dict[str, str] = {
    **dict.fromkeys(("clock_sleeps", "timer_clocks", "timer_queries"), _ENUMS),
    **dict.fromkeys(("values_parameters", "values_parameters_2"), _ENUMS),
    **dict.fromkeys(("values_nodes", "values_ros_args"), _INIT),
    **dict.fromkeys(("context_own", "ctrl_c_hooks"), "rclpy.shutdown() after Ctrl-C is no error, and calls the hooks"),
    **dict.fromkeys(("log_control", "log_levels"), "Logger.warn() is deprecated, as a warning says"),
    "node_destroyed": _ENUMS,
    "nodes_of_one_name": "when a context ends, the names of its nodes are forgotten while another goes on",
    "topics_destroyed": "publishing through a publisher that was destroyed is an InvalidHandle",
    "topics_values": "two messages of errors read differently",
    "values_duration": "durations can be added, subtracted and multiplied",
}

SCENARIO_LIST = [
    Scenario(file.stem, args, _name(file.stem, args, number))
    for file in sorted(SCENARIOS.glob("*.py"))
    if file.stem != "scenario"
    for number, args in enumerate(_ARGS.get(file.stem, [()]), 1)
]


def on_the_real_one(nodes: Children, scenario: Scenario) -> str:
    """The console of a scenario on the real rclpy; its status in the first line."""
    return _on_rclpy(nodes, scenario, ros2.python())


def on_kilted(nodes: Children, scenario: Scenario) -> str:
    """The same on that of Kilted."""
    return _on_rclpy(nodes, scenario, str(KILTED_PYTHON))


def on_the_wall(children: Children, scenario: Scenario) -> str:
    """The same on the stand-in, on the wall clock."""
    return _run(children, scenario, [sys.executable, "-m", "rosspin", "run", str(scenario.path), "--"])


def _on_rclpy(nodes: Children, scenario: Scenario, python: str) -> str:
    text = _run(nodes, scenario, [python, str(scenario.path)])
    # A run that met rclpy's own shutdown was unlucky, like one on a machine that stalled.
    return text + "@stall\n" if MET_SHUTDOWN.search(text) else text


def _run(children: Children, scenario: Scenario, command: list[str]) -> str:
    output = run_scenario(children, [*command, *scenario.args], scenario.end or LONGEST, scenario.is_timed)
    return f"status {output.status}\n{output.console}"


def simulated(scenario: Scenario, *more: str) -> Outcome:
    """The outcome of a scenario in simulated time."""
    with mock.patch.dict(os.environ):  # a node may set the form of its log lines there
        run = simulate(scenario.path, scenario.end or LONGEST, [*scenario.args, *more])
    return outcome(run.console, run.status, scenario.end)


def read(text: str, scenario: Scenario) -> Outcome:
    """The outcome that a text with the status in its first line tells of."""
    status, _, console = text.partition("\n")
    return outcome(console, int(status.removeprefix("status ")), scenario.end)


def recorded(scenario: Scenario) -> list[Outcome]:
    """What the real one gave: one outcome, several if it is a race."""
    files = sorted(RECORDED.glob(f"{scenario.name}*.txt"))
    return [read(file.read_text(), scenario) for file in files if file.stem.split("~")[0] == scenario.name]


def closest(exact: Sequence[Outcome], other: Outcome) -> list[str]:
    """How an outcome differs from that one of several which is most like it."""
    return min((differences(one, other) for one in exact), key=len, default=["nothing is recorded"])


def until_sure(run: Iterator[str], scenario: Scenario, exact: Sequence[Outcome]) -> tuple[str, list[str]]:
    """Run until it did what it should or the machine did not stall: the console, and how it differs."""
    for _, text in zip(range(TRIES), run):
        found = closest(exact, read(text, scenario))
        if not found or not read(text, scenario).stalled:
            break
    return text, found


# --- on the command line ----------------------------------------------------------------------------------------------


def _chosen(names: Sequence[str]) -> list[Scenario]:
    return [scenario for scenario in SCENARIO_LIST if not names or any(map(scenario.name.startswith, names))]


def _record(nodes: Children, scenario: Scenario) -> str:
    """Run a scenario twice and record it if nothing is, or if it is a race; what is to be said of it."""
    runs = iter(lambda: on_the_real_one(nodes, scenario), None)
    known = recorded(scenario)
    first, _ = until_sure(runs, scenario, ())
    said = []
    for text in (first, until_sure(runs, scenario, [read(first, scenario)])[0]):
        if not (found := closest(known, read(text, scenario))):
            continue
        if known:
            said += ["differs from what is recorded:", *(line[:300] for line in found)]
        if not known or scenario.name in RACES:
            known.append(read(text, scenario))
            more = f"~{len(known)}" if len(known) > 1 else ""
            (RECORDED / f"{scenario.name}{more}.txt").write_text(_kept(text))
            said.append("recorded")
    return f"{scenario.name}: " + ("\n  ".join(said) or "as before")


def _kept(text: str) -> str:
    """A console without what differs in every run, or on another machine."""
    for pattern, kept in (
        (r"@(zero|stall.*)\n", ""),
        (r"\[\d+\.\d{9}\]", "[STAMP]"),
        (r"\b0x[0-9a-f]+", "0xN"),
        (r", at \S+:\d+", ""),
        (r'(?m)^  File "(?!.*/scenarios_ros2/).*\n(?:    .*\n)*', ""),
        (r'File "/.*/scenarios_ros2/', 'File "/scenarios_ros2/'),
    ):
        text = re.sub(pattern, kept, text)
    return text


def main(words: list[str]) -> int:
    """See above; the status is 1 if anything differs."""
    RECORDED.mkdir(exist_ok=True)
    if "--simulated" in words:
        bad = 0
        for scenario in _chosen([word for word in words if word != "--simulated"]):
            if found := closest(recorded(scenario), simulated(scenario)):
                print(f"{scenario.name}:", *(line[:300] for line in found), sep="\n  ", flush=True)
                bad += 1
        print(f"{bad} of {len(SCENARIO_LIST)} differ")
        return int(bad > 0)
    if ros2.missing():
        raise SystemExit(str(ros2.Ros2Missing()))
    with ros2.Nodes() as nodes, ThreadPoolExecutor(AT_ONCE) as pool:
        for said in pool.map(lambda scenario: _record(nodes, scenario), _chosen(words)):
            print(said, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
