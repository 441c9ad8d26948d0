"""The rule of roscpp's timer gives what the real one gave, for the block lengths of the pages and for random ones."""

from __future__ import annotations

import re
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from cpp_nodes import CppNodes
from record import PERIOD, random_blocks
from seeds import SEED
from tree import ROOT
from verdicts import control

from rosspin import Tick, simulate
from rosspin.real.ros1 import Workspace
from rosspin.results.recordings import load
from rosspin.results.roscpp import timer_probe, timer_ticks

# The recordings of timers of timer_probe.cpp, in a node that spins at once in one thread.
RECORDINGS = sorted(ROOT.glob("examples/recordings/t*_cpp_[bs]*.csv"))
LATE = 0.1  # s: a fifth of the period; no two rules are that close


def differences(rule: Sequence[Tick], real: Sequence[Tick]) -> list[str]:
    """Where the ticks are not those of the rule, by the clock or by their own account."""
    found = [f"{len(rule)} ticks, not {len(real)}"] if abs(len(rule) - len(real)) > 1 else []
    for ours, theirs in zip(rule, real, strict=False):
        off = max(abs(ours.real - theirs.real), abs(ours.expected - theirs.expected))
        if ours.source != theirs.source or off > LATE:
            found.append(f"{ours}, not {theirs}")
    return found


def test_there_are_recordings_of_random_lengths() -> None:
    assert sum("_random_" in file.name for file in RECORDINGS) == 3
    assert len(RECORDINGS) == 10


@pytest.mark.parametrize("file", RECORDINGS, ids=lambda file: file.stem)
def test_the_rule_gives_what_was_recorded(file: Path) -> None:
    recorded = load(file)
    args = re.findall(r"_\w+:=\S+", recorded.provenance["command"])
    assert differences(timer_probe(recorded.seconds, args), recorded.ticks) == []


def test_another_rule_would_be_noticed() -> None:
    """rospy's, with its limit of 3 periods in place of 2."""
    recorded = load(ROOT / "examples/recordings/timer_cpp_blocks_random_1.csv")
    args = re.findall(r"_\w+:=\S+", recorded.provenance["command"])
    rospys = simulate(ROOT / "examples/timing_probes/src/timer_probe.py", recorded.seconds, args)
    assert differences(rospys.ticks, recorded.ticks)


def test_the_real_roscpp_follows_the_rule(cpp_nodes: CppNodes) -> None:
    """Over lengths drawn anew, with one timer and with two."""
    seconds = 12.0
    with Workspace() as workspace:
        workspace.start_master()
        program = cpp_nodes.program("timer_probe")

        def compare(seed: int) -> list[str]:
            args = [f"_period:={PERIOD}", f"_blocks:={','.join(map(str, random_blocks(seed, 20)))}"]
            args += ["_second_timer:=true"] * (seed % 2)
            command = [program, *args, f"__name:=probe_{seed}"]
            lines = workspace.run(command, seconds, begins=re.compile("^start,")).console.splitlines()
            start = next(float(line.partition(",")[2]) for line in lines if line.startswith("start,"))
            rows = [line.split(",") for line in lines if "Callback," in line]
            real = [Tick(row[0], int(row[1]), float(row[4]) - start, float(row[5]) - start, 0.0) for row in rows]
            return differences(timer_probe(seconds, args), real)

        with control(bears=LATE / 2), ThreadPoolExecutor() as pool:
            assert list(pool.map(compare, range(SEED, SEED + 4))) == [[], [], [], []]


def test_the_rule_by_itself() -> None:
    def times(length: float) -> list[float]:
        return [tick.real for tick in timer_ticks(0.5, lambda number: length * (number == 3), 4.2)][2:6]

    assert times(0.7) == [1.5, 2.2, 2.5, 3.0]
    assert times(1.0) == [1.5, 2.5, 2.5, 3.0]  # the limit itself: the grid is kept
    assert times(1.001) == [1.5, 2.501, 3.001, 3.501]
    assert times(2.2) == [1.5, 3.7, 4.2]


def test_what_is_not_about_the_timer_is_refused() -> None:
    with pytest.raises(ValueError, match="knows no threads, wait"):
        timer_probe(1.0, ["_period:=0.5", "_threads:=2", "_second_timer:=true", "_wait:=1"])
