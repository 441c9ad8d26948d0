"""All scenarios on the real ROS 1 and 2 and on the wall clock.

What is not recorded is recorded here, and the ledger says what was confirmed. A recording that the real ROS no longer
confirms fails; if it is the scenario or the real one that has changed, delete the recording.
"""

from __future__ import annotations

import random
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from rosspin.results.saving import save_whole
from tests.helpers import corpus_ros1, corpus_ros2, expectations
from tests.helpers.corpus import Scenario, closest, read, recorded, simulated
from tests.helpers.lacking import LACKS
from tests.helpers.ledger import Ledger
from tests.helpers.outcomes import JITTER, differences
from tests.helpers.runs import Case, Runs, asked_for, check, is_spoilt
from tests.helpers.runtimes import RUNTIMES, kept, version
from tests.helpers.seeds import SEED
from tests.helpers.verdicts import inconclusive

PATIENCE = 600.0  # s, of which a quiet machine needs nothing
RACES = 5  # runs of a scenario whose outcome is a race
RANDOM = 12

SCENARIOS = [*corpus_ros1.SCENARIO_LIST, *corpus_ros2.SCENARIO_LIST]


def times(runtime: str, scenario: Scenario) -> int:
    return RACES if scenario.name in expectations.races(runtime) else 1


CASES = [
    pytest.param(runtime, scenario, id=f"{runtime}-{scenario.name}{f'~{number}' if number else ''}")
    for scenario in SCENARIOS
    for runtime in RUNTIMES[scenario.ros]
    for number in range(times(runtime, scenario))
]


@pytest.fixture(scope="module")
def runs(request: pytest.FixtureRequest) -> Iterator[Runs]:
    """Runs of those scenarios that are asked for."""
    asked = asked_for(request)
    cases: list[Case] = [(each["runtime"], each["scenario"]) for each in asked if "scenario" in each]
    with Runs({each["runtime"] for each in asked}, cases, PATIENCE) as runs:
        yield runs


@pytest.fixture(scope="module")
def ledger() -> Iterator[Ledger]:
    ledger = Ledger.read()
    yield ledger
    ledger.write()


@pytest.mark.parametrize("runtime, scenario", CASES)
def test_scenario(runs: Runs, ledger: Ledger, require: Callable[[str], None], runtime: str, scenario: Scenario) -> None:
    if runtime in LACKS:
        require(runtime)
    console = runs.console(runtime, scenario)
    if is_spoilt(runtime, scenario, console):
        ledger.races[f"mishaps on {runtime}"] = [ledger.races.get(f"mishaps on {runtime}", [0])[0] + 1]
    elif runtime == RUNTIMES[scenario.ros][0]:
        judge(ledger, scenario, console)
    else:
        check(runtime, scenario, console)


def judge(ledger: Ledger, scenario: Scenario, console: str) -> None:
    """Hold the recording to what the real one did, or record that if there is none."""
    runtime = RUNTIMES[scenario.ros][0]
    outcome, is_race = read(console, scenario), scenario.name in expectations.races(runtime)
    if found := closest(recorded(scenario), outcome):
        if outcome.stalled:
            inconclusive(f"{scenario.name} stood still for {outcome.stalled:.3f} s on {runtime}: {found}")
        if not scenario.recordings:
            ledger.races.pop(scenario.name, None)
        assert is_race or not scenario.recordings, "\n".join(found)
        record(scenario, console)
    if is_race:
        counts = ledger.races.setdefault(scenario.name, [])
        number = next(n for n, known in enumerate(recorded(scenario)) if not differences(known, outcome))
        counts += [0] * (number + 1 - len(counts))
        counts[number] += 1
    ledger.confirm(scenario, version(runtime))


def record(scenario: Scenario, console: str) -> None:
    """Keep a console, with the others of a race."""
    known = scenario.recordings
    folder = scenario.path.parent / "recorded"
    folder.mkdir(exist_ok=True)
    save_whole(folder / f"{scenario.name}{f'~{len(known) + 1}' if known else ''}.txt", kept(console).encode())


# --- random scenarios -------------------------------------------------------------------------------------------------

_TIMER = '''"""Made at random from seed {seed}."""

import rospy
from scenario import P
from scenario import begin
from scenario import block
from scenario import end_after
from scenario import mark_event


def callback(name, blocks):
    calls = []

    def call(event):
        calls.append(event)
        mark_event(name, event)
        block(blocks[len(calls) - 1] if len(calls) <= len(blocks) else 0)

    return call


begin("{name}")
{timers}
end_after(10.25)
'''

_RATE = '''"""Made at random from seed {seed}."""

import rospy
from scenario import P
from scenario import begin
from scenario import block
from scenario import mark

begin("{name}")
rate = rospy.Rate({hz} / P)
for periods in {blocks}:
    mark("pass")
    block(periods)
    rate.sleep()
mark("end_of_loop")
'''


def make_random(folder: Path, seed: int) -> Scenario:
    """A scenario that a little lateness does not change, drawn until there is one."""
    draw = random.Random(seed)
    name = f"random_{seed}"
    shutil.copy(corpus_ros1.SCENARIOS / "scenario.py", folder)
    while True:
        blocks = [[draw.choice((0, 0, *corpus_ros1.LENGTHS)) for _ in range(6)] for _ in range(draw.randint(1, 4))]
        if draw.random() < 0.5:
            timers = "\n".join(
                f"rospy.Timer(rospy.Duration({draw.choice((1, 1.5, 2))} * P), callback('timer{number}', {lengths}))"
                for number, lengths in enumerate(blocks)
            )
            text = _TIMER.format(seed=seed, name=name, timers=timers)
        else:
            text = _RATE.format(seed=seed, name=name, hz=draw.choice((1, 0.5)), blocks=blocks[0])
        (folder / f"{name}.py").write_text(text)
        scenario = Scenario(1, folder / f"{name}.py", (), name)
        simulated.cache_clear()
        if not any(differences(simulated(scenario), simulated(scenario, late)) for late in (JITTER / 4, JITTER)):
            return scenario


@pytest.mark.parametrize("runtime", RUNTIMES[1])
@pytest.mark.parametrize("seed", range(SEED, SEED + RANDOM))
def test_random_scenario(runs: Runs, require: Callable[[str], None], tmp_path: Path, runtime: str, seed: int) -> None:
    """It does on the real ROS 1 and on the wall clock what it does in simulated time."""
    if runtime in LACKS:
        require(runtime)
    scenario = make_random(tmp_path, seed)
    outcome = read(runs.console(runtime, scenario), scenario)
    if found := differences(simulated(scenario), outcome):
        if outcome.stalled:
            inconclusive(f"{scenario.name} stood still for {outcome.stalled:.3f} s on {runtime}: {found}")
        raise AssertionError("\n".join(found))
