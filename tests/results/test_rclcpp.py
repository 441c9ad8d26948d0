"""The rules of rclcpp's timer and Rate give what the real ones gave."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from tree import ROOT

from rosspin import simulate
from rosspin.measures import by_source
from rosspin.results.rclcpp import Timer, rate_passes, timer_probe, timer_ticks
from rosspin.results.recordings import load
from rosspin.results.rules import calculated

LATE = 0.1  # s: a fifth of the period; no two rules are that close


def differences(file: Path) -> list[str]:
    """Where the ticks of a recording are not those of the rule."""
    recorded = load(file)
    program, *args = recorded.provenance["command"].split()
    rules, real = (
        by_source(ticks) for ticks in (calculated(f"ros2/{program}.cpp", recorded.seconds, args), recorded.ticks)
    )
    found = [f"{list(rules)}, not {list(real)}"] if rules.keys() != real.keys() else []
    for source, rule in rules.items():
        if abs(len(rule) - len(real[source])) > 1:
            found.append(f"{len(rule)} ticks of {source}, not {len(real[source])}")
        before = math.nan
        for ours, theirs in zip(rule, real[source], strict=False):
            # When a call begins just as the next is due, jitter decides whether that one is lost.
            is_tie = abs(ours.expected - before) < 1e-9
            if abs(ours.real - theirs.real) > LATE or (abs(ours.expected - theirs.expected) > LATE and not is_tie):
                found.append(f"{ours}, not {theirs}")
            before = ours.real
    return found


def recorded() -> list[Path]:
    """The recordings that the rules know: of ``create_timer``, under one thread, or several with a group each."""
    kinds = "timer_cpp_2hz", "timer_cpp_blocks", "rate_cpp", "two_timers_cpp", "slow_timers_cpp"
    files = sorted(ROOT.glob("examples/recordings/ros2/*_cpp_*.csv"))
    return [
        file for file in files if file.stem.startswith(kinds) and not file.stem.endswith(("_default", "_reentrant"))
    ]


@pytest.mark.parametrize("file", recorded(), ids=lambda file: file.stem)
def test_the_rule_gives_what_was_recorded(file: Path) -> None:
    assert differences(file) == []


def test_there_are_recordings_of_random_lengths() -> None:
    assert sum("_random_" in file.name for file in recorded()) == 4
    assert sum("timers_cpp" in file.name for file in recorded()) == 4


@pytest.mark.parametrize("kind", ["two", "slow"])
def test_of_two_that_are_due_the_one_made_last_is_called_first(kind: str) -> None:
    """In all that was recorded of one thread: the order of all calls is that of the rule."""
    run = load(ROOT / f"examples/recordings/ros2/{kind}_timers_cpp_spin.csv")
    rule = timer_probe(run.seconds, run.provenance["command"].split()[1:])
    assert [tick.source for tick in run.ticks] == [tick.source for tick in rule][: len(run.ticks)]


def test_the_rule_of_the_timer_is_that_of_rclpy() -> None:
    args = ["--ros-args", "-p", "block:=1.7", "-p", "block_call:=3"]
    own = simulate(ROOT / "examples/ros2/timer_probe.py", 6.0, args).ticks
    rule = timer_probe(6.0, args)
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

        timer, rate = timer_ticks([Timer("", 0.5, duration)], 9.0), rate_passes(0.5, duration, 9.0)
        return [tick.real for tick in timer][2:6], [round(tick.real, 3) for tick in rate][2:7]

    assert third(0.7) == ([1.5, 2.2, 2.5, 3.0], [1.0, 1.7, 2.0, 2.5, 3.0])
    assert third(1.0)[1] == [1.0, 2.0, 2.0, 2.5, 3.0]  # the limit itself: the grid is kept
    assert third(1.001)[1] == [1.0, 2.001, 2.501, 3.001, 3.501]
    assert third(1.7)[0] == [1.5, 3.2, 3.5, 4.0]
    assert third(1.7, 0.2)[1] == [1.0, 2.7, 3.4, 4.1, 4.7]  # until the clock has caught up with the mark


def test_what_the_rules_do_not_know_is_refused() -> None:
    with pytest.raises(ValueError, match="know no threads, wall"):
        timer_probe(1.0, ["-p", "threads:=2", "-p", "wall:=true"])
    with pytest.raises(ValueError, match="know no second_timer"):
        calculated("ros2/rate_probe.cpp", 1.0, ["-p", "second_timer:=true"])
    with pytest.raises(ValueError, match="wants a group of its own for each"):
        timer_probe(1.0, ["-p", "executor:=multi", "-p", "second_timer:=true"])
    with pytest.raises(ValueError, match="calls back without a pause"):
        timer_probe(1.0, ["-p", "period:=0.0"])
