"""The stand-in is held to the real rospy: the same scenario files on both, in simulated time and on the wall clock.

A scenario's times are compared with those of its simulated run, which are exact: as many marks of each label, each less
than TOLERANCE off. Blocks are chosen so that every decision (overrun or not) has a wide margin, which is tested, too. A
process that the machine has not let run for a while says so; then a difference is tried again, not allowed.
"""

from __future__ import annotations

import os
import random
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from unittest import mock

import pytest
from corpus_ros1 import _LENGTHS, LONGEST, SCENARIO_LIST, SCENARIOS, Scenario
from lacking import LACKS
from outcomes import JITTER, TRIES, Outcome, differences, outcome, run_scenario
from seeds import SEED
from tree import SOURCE

from rosspin import ros1, simulate

AT_ONCE = 8
RUNTIMES = ("ros1", "wall")

RANDOM = 12


def _simulated(folder: Path, scenario: Scenario, *args: str) -> Outcome:
    with mock.patch.dict(os.environ):  # a node may set the form of its log lines there
        run = simulate(folder / f"{scenario.file}.py", scenario.end or LONGEST, _args(scenario, *args))
    return outcome(run.console, run.status, scenario.end)


def _args(scenario: Scenario, *more: str) -> list[str]:
    # Nodes of one master need names of their own; those that print theirs have one.
    own = [] if scenario.file.startswith("values") else [f"__name:={scenario.name}"]
    return [*scenario.args, *own, *more]


# --- random scenarios -------------------------------------------------------------------------------------------------

_RANDOM_TIMER = '''"""Made at random from seed {seed}."""

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

_RANDOM_RATE = '''"""Made at random from seed {seed}."""

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


def _make_random(folder: Path, seed: int) -> Scenario:
    """A scenario that a little lateness does not change, drawn until there is one."""
    draw = random.Random(seed)
    scenario = Scenario(f"random_{seed}")
    while True:
        blocks = [[draw.choice((0, 0, *_LENGTHS)) for _ in range(6)] for _ in range(draw.randint(1, 4))]
        if draw.random() < 0.5:
            timers = "\n".join(
                f"rospy.Timer(rospy.Duration({draw.choice((1, 1.5, 2))} * P), callback('timer{number}', {lengths}))"
                for number, lengths in enumerate(blocks)
            )
            text = _RANDOM_TIMER.format(seed=seed, name=scenario.name, timers=timers)
        else:
            text = _RANDOM_RATE.format(seed=seed, name=scenario.name, hz=draw.choice((1, 0.5)), blocks=blocks[0])
        (folder / f"{scenario.file}.py").write_text(text)
        exact = _simulated(folder, scenario)
        late = [_simulated(folder, scenario, f"_jitter:={jitter}") for jitter in (JITTER / 4, JITTER)]
        if not any(differences(exact, outcome) for outcome in late):
            return scenario


# --- the runs ---------------------------------------------------------------------------------------------------------


class Lab:
    """Runs scenarios in ``runtimes``, some at a time, each until it is sure."""

    def __init__(
        self, folder: Path, runtimes: Sequence[str], workspace: ros1.Workspace, pool: ThreadPoolExecutor
    ) -> None:
        self.folder = folder
        self._runtimes = runtimes
        self._workspace = workspace
        self._pool = pool
        self._results: dict[tuple[Scenario, str], Future[list[str]]] = {}

    def submit(self, scenario: Scenario) -> None:
        exact = _simulated(self.folder, scenario)
        for runtime in self._runtimes:
            self._results[scenario, runtime] = self._pool.submit(self._compare, scenario, runtime, exact)

    def result(self, scenario: Scenario, runtime: str) -> list[str]:
        """How the run differed from the simulated one."""
        return self._results[scenario, runtime].result()

    def _compare(self, scenario: Scenario, runtime: str, exact: Outcome) -> list[str]:
        for _ in range(TRIES):
            outcome = self._run(scenario, runtime)
            found = differences(exact, outcome)
            if not found or not outcome.stalled:
                break
        return found

    def _run(self, scenario: Scenario, runtime: str) -> Outcome:
        file = str(self.folder / f"{scenario.file}.py")
        command = ["python3", file] if runtime == "ros1" else [sys.executable, "-m", "rosspin", "run", file, "--"]
        is_timed = "begin(" in Path(file).read_text()
        workspace = self._workspace
        with ExitStack() as stack:
            if runtime == "ros1" and scenario.file.startswith(("topics_clock", "topics_names")):
                # The time that they tell, the parameter that has them believed, and a topic that has another's name
                # in one run and not in the next are all nodes' of a master.
                workspace = stack.enter_context(ros1.Workspace())
                workspace.start_master()
            output = run_scenario(workspace, [*command, *_args(scenario)], scenario.end or LONGEST, is_timed)
        return outcome(output.console, output.status, scenario.end)


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    runtimes = [name for name in RUNTIMES if name not in LACKS or not LACKS[name]()]
    folder = tmp_path_factory.mktemp("lab") / "scenarios"
    shutil.copytree(SCENARIOS, folder, ignore=shutil.ignore_patterns("__pycache__"))
    for number in range(RANDOM):
        _make_random(folder, SEED + number)
    with pytest.MonkeyPatch.context() as patch, ros1.Workspace() as workspace:
        patch.setenv("PYTHONPATH", str(SOURCE))
        if "ros1" in runtimes:
            workspace.start_master()
        with ThreadPoolExecutor(AT_ONCE) as pool:
            lab = Lab(folder, runtimes, workspace, pool)
            for scenario in ALL:
                lab.submit(scenario)
            try:
                yield lab
            finally:
                pool.shutdown(cancel_futures=True)


ALL = [*SCENARIO_LIST, *(Scenario(f"random_{SEED + number}") for number in range(RANDOM))]


def _id(scenario: Scenario) -> str:
    return scenario.name


@pytest.mark.parametrize("runtime", RUNTIMES)
@pytest.mark.parametrize("scenario", ALL, ids=_id)
def test_scenario(lab: Lab, require: Callable[[str], None], scenario: Scenario, runtime: str) -> None:
    """The real rospy, where it is installed, and the stand-in on the wall clock do what it does in simulated time."""
    if runtime == "ros1":
        require("ros1")
    assert lab.result(scenario, runtime) == []


@pytest.mark.parametrize("scenario", [scenario for scenario in SCENARIO_LIST if scenario.is_timed], ids=_id)
def test_a_little_lateness_changes_no_scenario(scenario: Scenario) -> None:
    """The margins: else a busy machine could make a difference that rospy did not."""
    exact = _simulated(SCENARIOS, scenario)
    for jitter in (JITTER / 4, JITTER):
        assert differences(exact, _simulated(SCENARIOS, scenario, f"_jitter:={jitter}")) == []
