"""The stand-in for rclpy is held to the real one: the same scenario files on both, and on the wall clock.

What the real one gave is recorded beside the scenarios. Simulated runs are compared with that wherever the tests run,
and so is the real one where ROS 2 is installed; the stand-in on the wall clock is compared with its simulated runs.
Times are compared as in ``test_ros1_differential``, and runs that the machine has disturbed are repeated as there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor

import corpus_ros2
import pytest
from corpus_ros2 import (
    DIFFERENT,
    KILTED,
    RACES,
    RECORDED,
    SCENARIO_LIST,
    Scenario,
    closest,
    recorded,
    simulated,
    until_sure,
)
from lacking import LACKS
from outcomes import JITTER, differences
from tree import SOURCE

from rosspin import ros2
from rosspin.children import Children

AT_ONCE = 12
RUNTIMES = {"ros2": corpus_ros2.on_the_real_one, "kilted": corpus_ros2.on_kilted, "wall": corpus_ros2.on_the_wall}

Results = dict[tuple[Scenario, str], Future[list[str]]]


@pytest.fixture(scope="module")
def results() -> Iterator[Results]:
    """How each run differed from what it should be; what mostly sleeps runs side by side."""
    runtimes = [name for name in RUNTIMES if name not in LACKS or not LACKS[name]()]
    with pytest.MonkeyPatch.context() as patch, ros2.Nodes() as nodes, Children() as others:
        patch.setenv("PYTHONPATH", str(SOURCE))
        children: dict[str, Children] = {"ros2": nodes, "kilted": nodes, "wall": others}
        with ThreadPoolExecutor(AT_ONCE) as pool:

            def compare(scenario: Scenario, runtime: str) -> list[str]:
                exact = [simulated_ones[scenario]] if runtime == "wall" else recorded(scenario)
                runs = iter(lambda: RUNTIMES[runtime](children[runtime], scenario), None)
                return until_sure(runs, scenario, exact)[1]

            simulated_ones, futures = {}, {}
            for scenario in SCENARIO_LIST:
                simulated_ones[scenario] = simulated(scenario)
                for runtime in runtimes:
                    futures[scenario, runtime] = pool.submit(compare, scenario, runtime)
            try:
                yield futures
            finally:
                pool.shutdown(cancel_futures=True)


def _id(scenario: Scenario) -> str:
    return scenario.name


@pytest.mark.parametrize("scenario", SCENARIO_LIST, ids=_id)
def test_simulated_as_recorded(scenario: Scenario) -> None:
    """In simulated time a scenario does what it did on the real rclpy, or one of the things if that is a race."""
    found = closest(recorded(scenario), simulated(scenario))
    assert bool(found) == (scenario.name in DIFFERENT), found


@pytest.mark.parametrize("runtime", RUNTIMES)
@pytest.mark.parametrize("scenario", SCENARIO_LIST, ids=_id)
def test_scenario(results: Results, require: Callable[[str], None], scenario: Scenario, runtime: str) -> None:
    """The real rclpy, where it is installed, does what is recorded; the stand-in on the wall what is simulated."""
    if runtime in LACKS:
        require(runtime)
    elif scenario.name in RACES:
        pytest.skip(f"a race on the wall, too: {RACES[scenario.name]}")
    found = results[scenario, runtime].result()
    assert bool(found) == (runtime == "kilted" and scenario.name in KILTED), found


@pytest.mark.parametrize("scenario", [each for each in SCENARIO_LIST if each.is_timed], ids=_id)
def test_a_little_lateness_changes_no_scenario(scenario: Scenario) -> None:
    """The margins: else a busy machine could make a difference that rclpy did not."""
    exact = simulated(scenario)
    for jitter in (JITTER / 4, JITTER):
        assert differences(exact, simulated(scenario, f"jitter:={jitter}")) == []


def test_the_corpus_is_whole() -> None:
    """Every scenario is recorded, nothing else is; where there are several outcomes, it is said why."""
    files = [file.stem for file in RECORDED.glob("*.txt")]
    assert {name.split("~")[0] for name in files} == {scenario.name for scenario in SCENARIO_LIST}
    assert {name.split("~")[0] for name in files if "~" in name} <= RACES.keys()
    assert RACES.keys() | KILTED.keys() <= {scenario.name for scenario in SCENARIO_LIST}
    assert len({scenario.file for scenario in SCENARIO_LIST}) >= 60
