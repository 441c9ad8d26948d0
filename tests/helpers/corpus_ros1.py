"""The scenarios for ROS 1: their list."""

from __future__ import annotations

import re
from typing import NamedTuple

from outcomes import CTRL_C
from tree import TESTS

SCENARIOS = TESTS / "scenarios"

LONGEST = 12.0  # s of a scenario that ends by itself


class Scenario(NamedTuple):
    """A scenario file with its node args, which are a part of its name."""

    file: str
    args: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        return re.sub(r"\W+", "_", "_".join((self.file, *self.args)))

    @property
    def is_timed(self) -> bool:
        """Whether it is about times."""
        return not self.file.startswith(("values", "log_", "exit", "main"))

    @property
    def end(self) -> float | None:
        """When Ctrl-C comes, in those that are about it."""
        return CTRL_C if self.file.startswith("ctrl_c") else None


def _with(name: str, values: tuple[float, ...], *more: str) -> list[tuple[str, ...]]:
    return [(f"_{name}:={value}", *more) for value in values]


# Lengths, in periods, around the limits of 1, 2 and 3.
_LENGTHS = (0.5, 0.7, 1.3, 1.6, 2.4, 2.7, 3.3, 3.6, 4.4, 5.6)


_ARGS: dict[str, list[tuple[str, ...]]] = {
    "timer_blocked_once": _with("block", _LENGTHS),
    "timer_blocked_always": _with("block", (0.5, 1.6, 3.5)),
    "rate_blocked": _with("block", _LENGTHS, "_pass:=2") + _with("block", (0.5, 1.6, 3.5), "_pass:=0"),
    "ros_time_backward": [("_reset:=false",), ("_reset:=true",)],
    "values_names": [
        (),
        ("__ns:=/mrp", "chatter:=other", "plain"),
        ("__ns:=a/b", "__name:=renamed", "/chatter:=/x/y", "_p:=1", "--flag"),
        ("__ns:=/c", "~a:=b", "bad:=two:=three"),
    ],
    "values_parameters": [
        (
            *("_rate:=10", "_text:=word", "_yes:=true", "_list:=[1, 2.5, a]", "_tree:={a: {b: 1}}"),
            *("_empty:=''", "_float:=1e3", "_quoted:='10'"),
        )
    ],
    "values_bad_parameter": [("_a:={",)],
    "log_levels": [(level,) for level in ("DEBUG", "INFO", "WARN", "ERROR", "FATAL")],
    "exit_status": [("0",), ("3",)],
    "topics_queue_size": [(f"_queue_size:={size}",) for size in (0, 1, 3)],
    "topics_publisher_queue_size": [(f"_queue_size:={size}",) for size in (1, 10, 0)],
    "topics_names": [(), ("old:=new", "~private:=/elsewhere/topics"), ("__ns:=/mrp", "b:=c")],
    "threads_outlive_main_that_exits": [("soft",), ("hard",)],
}

SCENARIO_LIST = [
    Scenario(file.stem, args)
    for file in sorted(SCENARIOS.glob("*.py"))
    if file.stem != "scenario"
    for args in _ARGS.get(file.stem, [()])
]
