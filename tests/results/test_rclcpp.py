"""The rules of rclcpp's timer and Rate give what the real ones gave."""

from __future__ import annotations

from pathlib import Path

import pytest
from tree import ROOT

from rosspin import simulate
from rosspin.results.rclcpp import probe, rate_passes, timer_ticks
from rosspin.results.recordings import load

LATE = 0.1  # s: a fifth of the period; no two rules are that close


def differences(file: Path) -> list[str]:
    """Where the ticks of a recording are not those of the rule."""
    recorded = load(file)
    program, *args = recorded.provenance["command"].split()
    rule = probe(program, recorded.seconds, args)
    found = [f"{len(rule)} ticks, not {len(recorded.ticks)}"] if abs(len(rule) - len(recorded.ticks)) > 1 else []
    for ours, theirs in zip(rule, recorded.ticks, strict=False):
        if max(abs(ours.real - theirs.real), abs(ours.expected - theirs.expected)) > LATE:
            found.append(f"{ours}, not {theirs}")
    return found


def single_probes() -> list[Path]:
    """The recordings of one timer or loop that the rules know: made at once, under one thread, by ``create_timer``."""
    files = sorted(ROOT.glob("examples/recordings/ros2/*_cpp_*.csv"))
    return [file for file in files if file.stem.startswith(("timer_cpp_2hz", "timer_cpp_blocks", "rate_cpp"))]


@pytest.mark.parametrize("file", single_probes(), ids=lambda file: file.stem)
def test_the_rule_gives_what_was_recorded(file: Path) -> None:
    assert differences(file) == []


def test_there_are_recordings_of_random_lengths() -> None:
    assert sum("_random_" in file.name for file in single_probes()) == 4


def test_the_rule_of_the_timer_is_that_of_rclpy() -> None:
    args = ["--ros-args", "-p", "block:=1.7", "-p", "block_call:=3"]
    own = simulate(ROOT / "examples/ros2/timer_probe.py", 6.0, args).ticks
    rule = probe("timer_probe.cpp", 6.0, args)
    assert [(tick.expected, tick.real) for tick in rule] == [(tick.expected, tick.real) for tick in own]


def test_another_rule_of_the_rate_would_be_noticed() -> None:
    """rclpy's, which always keeps the grid."""
    recorded = load(ROOT / "examples/recordings/ros2/rate_cpp_blocks_once_2.4.csv").ticks
    args = ["--ros-args", "-p", "block:=1.2", "-p", "block_call:=3"]
    own = simulate(ROOT / "examples/ros2/rate_probe.py", 6.0, args).ticks
    assert max(abs(ours.real - theirs.real) for ours, theirs in zip(own, recorded, strict=False)) > LATE


def test_the_rules_by_themselves() -> None:
    def third(length: float, others: float = 0.0) -> tuple[list[float], list[float]]:
        def duration(number: int) -> float:
            return length if number == 3 else others

        timer, rate = timer_ticks(0.5, duration, 9.0), rate_passes(0.5, duration, 9.0)
        return [tick.real for tick in timer][2:6], [round(tick.real, 3) for tick in rate][2:7]

    assert third(0.7) == ([1.5, 2.2, 2.5, 3.0], [1.0, 1.7, 2.0, 2.5, 3.0])
    assert third(1.0)[1] == [1.0, 2.0, 2.0, 2.5, 3.0]  # the limit itself: the grid is kept
    assert third(1.001)[1] == [1.0, 2.001, 2.501, 3.001, 3.501]
    assert third(1.7)[0] == [1.5, 3.2, 3.5, 4.0]
    assert third(1.7, 0.2)[1] == [1.0, 2.7, 3.4, 4.1, 4.7]  # until the clock has caught up with the mark


def test_what_is_not_about_a_single_timer_is_refused() -> None:
    with pytest.raises(ValueError, match="know no second_timer, threads"):
        probe("timer_probe.cpp", 1.0, ["-p", "threads:=2", "-p", "second_timer:=true"])
    with pytest.raises(ValueError, match="calls back without a pause"):
        probe("timer_probe.cpp", 1.0, ["-p", "period:=0.0"])
