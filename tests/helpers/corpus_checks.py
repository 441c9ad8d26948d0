"""What is asked of a corpus in simulated time, which is the same for ROS 1 and 2."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from . import expectations
from .corpus import Scenario, closest, recorded, simulated
from .ledger import Ledger
from .outcomes import JITTER, differences

LEDGER = Ledger.read()

STAND_INS = {1: "the stand-in for rospy", 2: "the stand-in for rclpy"}


def each(scenarios: Sequence[Scenario]) -> pytest.MarkDecorator:
    """Ask it of each scenario."""
    return pytest.mark.parametrize("scenario", scenarios, ids=lambda scenario: scenario.name)


def check_recorded(scenario: Scenario) -> None:
    """In simulated time it does what it did on the real ROS, or one of the things if that is a race."""
    found = closest(recorded(scenario), simulated(scenario))
    assert bool(found) == (scenario.name in expectations.differences(STAND_INS[scenario.ros])), found


def check_late(scenario: Scenario) -> None:
    """A little lateness of each block changes nothing: else a busy machine could make a difference that ROS did not."""
    assert differences(simulated(scenario), simulated(scenario, JITTER)) == []


def check_whole(scenarios: Sequence[Scenario], folder: Path) -> None:
    """Every scenario is recorded and nothing else is; a race has as many recordings as outcomes."""
    ros = scenarios[0].ros
    names = {scenario.name for scenario in scenarios}
    files = [file.stem.partition("~")[0] for file in (folder / "recorded").glob("*.txt")]
    assert set(files) == names == LEDGER.entries[ros].keys()
    races = expectations.races(f"ros{ros}")
    assert {name: files.count(name) for name in races} == {name: len(race.outcomes) for name, race in races.items()}
    assert len(files) == len(names) + sum(len(race.outcomes) - 1 for race in races.values())
